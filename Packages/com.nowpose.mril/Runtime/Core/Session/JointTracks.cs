using System;
using System.Collections.Generic;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Prediction.Mixing;
using Nowpose.Protocol;
using Nowpose.Signals;

namespace Nowpose.Session
{
    /// <summary>Predictors of all moving joints, fed with messages that may each contain only some of the joints. Single-threaded.</summary>
    sealed class JointTracks
    {
        readonly RobotModel _robot;
        readonly JointPredictor[] _joints;
        readonly PastValues<double>[] _past;
        readonly double[] _positions;
        readonly double[] _held;
        readonly PredictionKind[] _kinds;
        readonly bool[] _isShown;
        readonly bool[] _given;
        readonly (int Joint, int Master)[] _mimics;
        readonly LimitWatch _limits;
        readonly double _horizonCap;
        // Display times at which the last two samples of each joint arrived that were too old to be displayed. One does not show a wrong clock: the
        // gateway sends the newest sample of a joint again to a new subscriber.
        readonly (double Before, double Newest)[] _oldArrivals;
        bool _hasEpoch;
        double _displayed = double.NaN;
        ControlTime _epoch;

        public JointTracks(RobotModel robot, PredictionSettings settings)
        {
            _robot = robot;
            var count = robot.MovingJoints.Count;
            _joints = new JointPredictor[count];
            _past = new PastValues<double>[count];
            var gap = ClockTicks.Seconds(settings.MaximumGap);
            var forecasters = Predictors.ForecastersOfJoints();
            for (var i = 0; i < count; i++)
            {
                var bounds = BoundsOf(robot.MovingJoints[i], settings);
                _joints[i] = settings.Create(bounds, forecasters);
                _past[i] = bounds.IsEndless ? new PastValues<double>(gap, AngleBetween) : new PastValues<double>(gap, Between);
            }
            _positions = new double[count];
            _held = new double[count];
            _kinds = new PredictionKind[count];
            _isShown = new bool[count];
            _given = new bool[count];
            _mimics = MimicsOf(robot);
            _limits = new LimitWatch(robot);
            _horizonCap = ClockTicks.Seconds(settings.HorizonCap);
            _oldArrivals = new (double, double)[count];
            Reset();
        }

        /// <summary>Joints with samples outside their limits; their positions are drawn at the limit.</summary>
        public LimitWatch Limits => _limits;

        /// <summary>Positions at the last <see cref="Predict"/>, one per moving joint, rad or m.</summary>
        public ReadOnlySpan<double> Positions => _positions;

        /// <summary>Newest samples at the last <see cref="Predict"/>: the positions that a display without compensation would show.</summary>
        public ReadOnlySpan<double> Held => _held;

        /// <summary>Whether each joint has the position of its own samples at the last <see cref="Predict"/>; only set for mimic joints.</summary>
        public ReadOnlySpan<bool> Given => _given;

        /// <summary>
        /// Method by which each position was computed. A joint without samples since a reset counts as held if it was shown before; a mimic joint
        /// that follows its master has the kind of its master.
        /// </summary>
        public ReadOnlySpan<PredictionKind> Kinds => _kinds;

        /// <summary>Returns whether a joint has received a sample since the last <see cref="Reset"/>.</summary>
        public bool HasSample(int joint) => !double.IsNegativeInfinity(_joints[joint].NewestTime);

        /// <summary>Returns whether the displayed position of a joint comes from a sample, of the joint or of its master, even before a reset.</summary>
        public bool HasPosition(int joint) => _kinds[joint] != PredictionKind.None;

        /// <summary>Returns the control time of a joint's newest sample; null while there is none.</summary>
        public ControlTime? NewestOf(int joint) =>
            HasSample(joint) ? _epoch + ClockTicks.Span(_joints[joint].NewestTime) : (ControlTime?)null;

        /// <summary>Returns the control time of the newest sample of any of the joints; null while there is none.</summary>
        public ControlTime? NewestOf(int[] joints)
        {
            ControlTime? newest = null;
            foreach (var joint in joints)
                if (NewestOf(joint) is ControlTime time && !(time <= newest)) newest = time;
            return newest;
        }

        /// <summary>Returns whether at least two samples of a joint have arrived in the last 3 s that were already too old to be displayed.</summary>
        public bool ReceivesOldSamples(int joint) => _displayed - _oldArrivals[joint].Before <= 3;

        /// <summary>
        /// Raised within <see cref="Add"/> with the index of a joint whose earlier samples were removed, because the clock of the samples went back or the newest
        /// stamp was wrong.
        /// </summary>
        public event Action<int> Restarted;

        /// <param name="joints">
        /// Index among the robot's moving joints for each joint of the message; negative for a joint that the robot does not have.
        /// </param>
        /// <returns>Reason why the message was dropped; <see cref="DropReason.None"/> if at least one joint used its sample.</returns>
        public DropReason Add(JointStateMessage message, ReadOnlySpan<int> joints)
        {
            var time = SecondsOf(message.Stamp);
            var reason = DropReason.UnknownJoint;
            var hasRestarted = false;
            for (var i = 0; i < joints.Length; i++)
            {
                var joint = joints[i];
                if (joint < 0) continue;
                var restarts = _joints[joint].Restarts;
                var each = _joints[joint].Add(Sample(time, message, i), _displayed);
                if (reason != DropReason.None) reason = each;
                var hasGoneBack = _joints[joint].Restarts != restarts;
                hasRestarted |= hasGoneBack;
                // A sample with a stamp in the future is newer than those that follow, so it would hide them.
                if (hasGoneBack || _joints[joint].IsNewestStampWrong)
                {
                    _past[joint].Clear();
                    Restarted?.Invoke(joint);
                }
                if (each != DropReason.None) continue;
                if (_displayed - time > _horizonCap) _oldArrivals[joint] = (_oldArrivals[joint].Newest, _displayed);
                _limits.Add(joint, message.Positions[i]);
                _past[joint].Add(time, message.Positions[i]);
            }
            if (hasRestarted) RestartOthers(time, message, joints);
            return reason;
        }

        // All joints of a message have the same clock. The positions of a moving joint are the first to show that the clock went back; those of a
        // joint at rest do not show it.
        void RestartOthers(double time, JointStateMessage message, ReadOnlySpan<int> joints)
        {
            for (var i = 0; i < joints.Length; i++)
            {
                var joint = joints[i];
                if (joint < 0 || !(_joints[joint].NewestTime > time)) continue;
                _joints[joint].Reset();
                _past[joint].Clear();
                _joints[joint].Add(Sample(time, message, i), _displayed);
                _past[joint].Add(time, message.Positions[i]);
                Restarted?.Invoke(joint);
            }
        }

        /// <summary>Applies a plan of the control system. Allocates nothing.</summary>
        public void Follow(PlannedMotion plan)
        {
            var start = SecondsOf(plan.Stamp);
            for (var i = 0; i < plan.Count; i++) _joints[plan.JointAt(i)].Follow(plan.PathAt(i), start, _displayed);
        }

        /// <inheritdoc cref="PredictionSettings.Bounded"/>
        public static JointLimits BoundsOf(RobotJoint joint, PredictionSettings settings) =>
            settings.Bounded(joint.Limits, joint.Kind != JointKind.Prismatic);

        static JointSample Sample(double time, JointStateMessage message, int i) => new JointSample(
            time, message.Positions[i], time, message.Velocities?[i] ?? double.NaN, message.Accelerations?[i] ?? double.NaN);

        /// <summary>Predicts all joints to a control time. Allocates nothing.</summary>
        /// <param name="isDisplayed">Whether the positions are displayed. The next samples are blended in from the displayed positions.</param>
        public void Predict(ControlTime at, bool isDisplayed = true)
        {
            var time = ClockTicks.Seconds(at - _epoch);
            // Before the first sample, the epoch is unknown.
            if (_hasEpoch && isDisplayed) _displayed = time;
            for (var i = 0; i < _joints.Length; i++)
            {
                var prediction = _joints[i].At(time);
                Show(i, prediction.Kind, prediction.Position);
            }
            CompleteMimics();
        }

        /// <summary>
        /// Computes the positions at a time other than the display time, up to 1.2 s before the newest samples. Joints without samples keep their displayed
        /// positions.
        /// </summary>
        /// <param name="judged">Joints whose data determine the result's origin; must not contain mimic joints.</param>
        /// <param name="positions">Receives one position per moving joint.</param>
        public PoseOrigin At(ControlTime at, int[] judged, double[] positions)
        {
            var time = ClockTicks.Seconds(at - _epoch);
            for (var i = 0; i < positions.Length; i++) positions[i] = HasSample(i) ? PositionAt(i, time, out _) : _positions[i];
            _robot.CompleteMimics(positions, _given);
            var least = PoseOrigin.Measured;
            foreach (var joint in judged)
            {
                PositionAt(joint, time, out var origin);
                if (origin < least) least = origin;
            }
            return least;
        }

        double PositionAt(int joint, double time, out PoseOrigin origin)
        {
            var prediction = _joints[joint].At(time);
            var isKnown = IsPredicted(prediction.Kind);
            origin = !isKnown ? PoseOrigin.None : time > _joints[joint].NewestTime ? PoseOrigin.Forecast : PoseOrigin.Measured;
            if (isKnown || !_past[joint].TryGet(time, out var past)) return prediction.Position;
            origin = PoseOrigin.Measured;
            return past;
        }

        static double Between(double before, double after, double fraction) => before + fraction * (after - before);

        static double AngleBetween(double before, double after, double fraction) =>
            Between(before, after - JointPredictor.WholeTurns(after - before), fraction);

        /// <summary>Computes the planned positions at a given time, however far in the future. Other joints keep their displayed positions.</summary>
        /// <param name="needed">Joints that must follow a plan at that time.</param>
        /// <param name="positions">Receives one position per moving joint.</param>
        /// <returns>False if a needed joint follows no plan at that time, or if no joint is needed.</returns>
        public bool TryPlan(ControlTime at, int[] needed, double[] positions)
        {
            var time = ClockTicks.Seconds(at - _epoch);
            _positions.CopyTo(positions, 0);
            foreach (var joint in needed)
                if (!HasSample(joint) || !_joints[joint].TryPlan(time, out positions[joint])) return false;
            _robot.CompleteMimics(positions, _given);
            return needed.Length > 0;
        }

        /// <summary>
        /// Shows the newest samples unchanged, marked as held, if positions cannot be predicted or must be held. Allocates nothing.
        /// </summary>
        public void Hold()
        {
            for (var i = 0; i < _joints.Length; i++)
            {
                Show(i, HasSample(i) ? PredictionKind.Held : PredictionKind.None, _joints[i].Hold);
            }
            CompleteMimics();
        }

        /// <summary>Removes all samples because their times are no longer valid. The displayed positions are kept.</summary>
        public void Reset()
        {
            foreach (var joint in _joints) joint.Reset();
            foreach (var past in _past) past.Clear();
            _hasEpoch = false;
            _displayed = double.NaN;
            Array.Fill(_oldArrivals, (double.NaN, double.NaN));
        }

        double SecondsOf(ControlTime stamp)
        {
            if (!_hasEpoch) _epoch = stamp;
            _hasEpoch = true;
            return ClockTicks.Seconds(stamp - _epoch);
        }

        // A joint without a sample keeps its position, because a jump to the zero pose would be worse than a delayed pose.
        void Show(int joint, PredictionKind kind, double position)
        {
            _isShown[joint] |= kind != PredictionKind.None;
            if (kind != PredictionKind.None)
            {
                _positions[joint] = position;
                _held[joint] = _joints[joint].Hold;
            }
            _kinds[joint] = kind == PredictionKind.None && _isShown[joint] ? PredictionKind.Held : kind;
        }

        // A mimic joint follows its master if its own samples have ended before those of the master.
        void CompleteMimics()
        {
            foreach (var (joint, master) in _mimics)
            {
                if (IsPredicted(_kinds[joint])) _given[joint] = true;
                else if (IsPredicted(_kinds[master])) _given[joint] = false;
                else _given[joint] |= HasSample(joint) && _joints[joint].NewestTime >= _joints[master].NewestTime;
            }
            _robot.CompleteMimics(_positions, _given);
            _robot.CompleteMimics(_held, _given);
            foreach (var (joint, master) in _mimics)
                if (!_given[joint]) _kinds[joint] = _kinds[master];
        }

        static bool IsPredicted(PredictionKind kind) => kind != PredictionKind.None && kind != PredictionKind.Held;

        static (int Joint, int Master)[] MimicsOf(RobotModel robot)
        {
            var mimics = new List<(int, int)>();
            foreach (var joint in robot.MovingJoints)
                if (joint.Mimic != null) mimics.Add((joint.MovingIndex, robot.MasterOf(joint).MovingIndex));
            return mimics.ToArray();
        }
    }
}
