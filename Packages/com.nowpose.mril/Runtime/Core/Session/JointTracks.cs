using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>One predictor per moving joint, fed with messages that may each carry only some of them. One thread.</summary>
    sealed class JointTracks
    {
        readonly RobotModel _robot;
        readonly JointPredictor[] _joints;
        readonly double[] _positions;
        readonly double[] _held;
        readonly PredictionKind[] _kinds;
        readonly bool[] _given;
        readonly (int Joint, int Master)[] _mimics;
        readonly LimitWatch _limits;
        bool _hasEpoch;
        double _displayed = double.NaN;
        ControlTime _epoch;

        public JointTracks(RobotModel robot, PredictionSettings settings)
        {
            _robot = robot;
            var count = robot.MovingJoints.Count;
            _joints = new JointPredictor[count];
            for (var i = 0; i < count; i++) _joints[i] = settings.Create(BoundsOf(robot.MovingJoints[i], settings));
            _positions = new double[count];
            _held = new double[count];
            _kinds = new PredictionKind[count];
            _given = new bool[count];
            _mimics = MimicsOf(robot);
            _limits = new LimitWatch(robot);
        }

        /// <summary>Joints whose samples are where their limits do not let them be: their positions are drawn at the limit.</summary>
        public LimitWatch Limits => _limits;

        /// <summary>Positions at the last <see cref="Predict"/>, one per moving joint, rad or m.</summary>
        public ReadOnlySpan<double> Positions => _positions;

        /// <summary>The newest samples at the last <see cref="Predict"/>: what a display without compensation shows.</summary>
        public ReadOnlySpan<double> Held => _held;

        /// <summary>
        /// How each position was made. A joint without samples since a reset counts as held once it was shown; a mimic joint
        /// without samples of its own is made as its master was.
        /// </summary>
        public ReadOnlySpan<PredictionKind> Kinds => _kinds;

        /// <summary>Control time of the newest sample of any joint at the last <see cref="Predict"/>; null while there is none.</summary>
        public ControlTime? Newest { get; private set; }

        /// <summary>Whether a joint has had a sample since the last <see cref="Reset"/>.</summary>
        public bool HasSample(int joint) => !double.IsNegativeInfinity(_joints[joint].NewestTime);

        /// <summary>Control time of a joint's newest sample; null while there is none.</summary>
        public ControlTime? NewestOf(int joint) =>
            HasSample(joint) ? _epoch + ClockTicks.Span(_joints[joint].NewestTime) : (ControlTime?)null;

        /// <summary>A joint's source went back in time and its samples of before are forgotten; raised within <see cref="Add"/>.</summary>
        public event Action<int> StartedAnew;

        /// <param name="joints">Indices of the message's joints among the robot's moving joints; negative for others.</param>
        /// <returns>Why the message was of no use; <see cref="DropReason.None"/> when a joint took its sample.</returns>
        public DropReason Add(JointStateMessage message, ReadOnlySpan<int> joints)
        {
            var time = SecondsOf(message.Stamp);
            var reason = DropReason.UnknownJoint;
            for (var i = 0; i < joints.Length; i++)
            {
                var joint = joints[i];
                if (joint < 0) continue;
                var outcome = _joints[joint].Add(Sample(time, message, i), _displayed);
                var each = ReasonOf(outcome);
                if (each == DropReason.None) _limits.Add(joint, message.Positions[i]);
                if (reason != DropReason.None) reason = each;
                if (outcome == SampleOutcome.StartedAnew) StartedAnew?.Invoke(joint);
            }
            return reason;
        }

        /// <summary>Takes what the control system means to do. Allocates nothing.</summary>
        public void Follow(PlannedMotion plan)
        {
            var start = SecondsOf(plan.Stamp);
            for (var i = 0; i < plan.Count; i++) _joints[plan.JointAt(i)].Follow(plan.PathAt(i), start, _displayed);
        }

        static JointLimits BoundsOf(RobotJoint joint, PredictionSettings settings) =>
            settings.Bounded(joint.Limits, joint.Kind != JointKind.Prismatic);

        static JointSample Sample(double time, JointStateMessage message, int i) => new JointSample(
            time, message.Positions[i], time, message.Velocities?[i] ?? double.NaN, message.Accelerations?[i] ?? double.NaN);

        /// <summary>All joints at a control time. Allocates nothing.</summary>
        public void Predict(ControlTime at)
        {
            var time = ClockTicks.Seconds(at - _epoch);
            // Before the first sample the epoch is unknown.
            if (_hasEpoch) _displayed = time;
            var newest = double.NegativeInfinity;
            for (var i = 0; i < _joints.Length; i++)
            {
                var prediction = _joints[i].At(time);
                Show(i, prediction.Kind, prediction.Position);
                newest = Math.Max(newest, _joints[i].NewestTime);
            }
            Newest = double.IsNegativeInfinity(newest) ? (ControlTime?)null : _epoch + ClockTicks.Span(newest);
            CompleteMimics();
        }

        /// <summary>The newest samples as they are, all marked held: no time is known to predict to. Allocates nothing.</summary>
        public void Hold()
        {
            for (var i = 0; i < _joints.Length; i++)
            {
                Show(i, HasSample(i) ? PredictionKind.Held : PredictionKind.None, _joints[i].Hold);
            }
            CompleteMimics();
        }

        /// <summary>Forgets all samples, for their times mean nothing any more; what is displayed stays.</summary>
        public void Reset()
        {
            foreach (var joint in _joints) joint.Reset();
            _hasEpoch = false;
            _displayed = double.NaN;
        }

        double SecondsOf(ControlTime stamp)
        {
            if (!_hasEpoch) _epoch = stamp;
            _hasEpoch = true;
            return ClockTicks.Seconds(stamp - _epoch);
        }

        // Without a sample the joint stays where it was: a robot that folds into its zero pose would be worse than a late one.
        void Show(int joint, PredictionKind kind, double position)
        {
            _given[joint] |= kind != PredictionKind.None;
            if (kind != PredictionKind.None)
            {
                _positions[joint] = position;
                _held[joint] = _joints[joint].Hold;
            }
            _kinds[joint] = kind == PredictionKind.None && _given[joint] ? PredictionKind.Held : kind;
        }

        void CompleteMimics()
        {
            _robot.CompleteMimics(_positions, _given);
            _robot.CompleteMimics(_held, _given);
            foreach (var (joint, master) in _mimics)
                if (!_given[joint]) _kinds[joint] = _kinds[master];
        }

        // Along a chain of mimic joints each master is the end of the chain: the joint that has samples.
        static (int Joint, int Master)[] MimicsOf(RobotModel robot)
        {
            var mimics = new List<(int, int)>();
            foreach (var joint in robot.MovingJoints)
            {
                var master = joint;
                while (master.Mimic != null) master = robot.MovingJoints[robot.IndexOfMovingJoint(master.Mimic.Master)];
                if (master != joint) mimics.Add((joint.MovingIndex, master.MovingIndex));
            }
            return mimics.ToArray();
        }

        static DropReason ReasonOf(SampleOutcome outcome)
        {
            switch (outcome)
            {
                case SampleOutcome.Duplicate: return DropReason.DuplicateSample;
                case SampleOutcome.TooOld: return DropReason.LateSample;
                default: return DropReason.None;
            }
        }
    }
}
