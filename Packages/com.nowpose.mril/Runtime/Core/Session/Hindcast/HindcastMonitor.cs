using System;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Protocol;

namespace Nowpose.Session.Hindcast
{
    /// <summary>
    /// Computes the errors of the displayed tool and joints relative to their true positions from later samples, and the same errors
    /// of the uncompensated hold.
    /// </summary>
    /// <remarks>
    /// The true pose at a display time is the forward kinematics of the joints on the curves through their surrounding samples. It is
    /// computed when the second sample after the display time has arrived. It does not include errors common to all samples, such as errors
    /// of the clock or of L_visu. A mimic joint with its own samples has a true position of its own. Allocates nothing after construction;
    /// single-threaded.
    /// </remarks>
    sealed class HindcastMonitor
    {
        readonly RobotModel _robot;
        readonly HindcastKinematics _kinematics;
        readonly TimeSpan _maximumGap;
        // The joints between base and tool with their own samples, then the mimic joints, which may have their own samples.
        readonly int[] _joints;
        readonly int[] _placeOfJoint;
        // Whether the true position of each joint is needed. False for a mimic joint while it follows its master.
        readonly bool[] _isNeeded;
        readonly bool[] _isEndless;
        readonly TruthTrack[] _tracks;
        readonly ShownFrames _frames;
        readonly ErrorWindow _tool = new ErrorWindow();
        readonly ErrorRun _toolOfRun = new ErrorRun();
        readonly ErrorWindow[] _ofJoint;
        readonly ShownFrames.JointValues[] _values;
        readonly TrueSpeeds _speeds;
        ControlTime? _now;
        ControlTime? _runSince;
        bool _hasRunBegun;
        ErrorWithheldReason _withheldOfRun;

        /// <param name="settings">Settings with the maximum interval between samples; the motion within a longer interval is unknown.</param>
        public HindcastMonitor(RobotModel robot, PredictionSettings settings)
        {
            _robot = robot;
            _maximumGap = settings.MaximumGap;
            var independent = ToolJoints.Of(robot);
            JointCount = independent.Length;
            _joints = independent.Concat(ToolJoints.MimicsOf(robot)).ToArray();
            _isNeeded = new bool[_joints.Length];
            Array.Fill(_isNeeded, true, 0, JointCount);
            _kinematics = new HindcastKinematics(robot, _joints);
            _placeOfJoint = new int[robot.MovingJoints.Count];
            for (var i = 0; i < _placeOfJoint.Length; i++) _placeOfJoint[i] = Array.IndexOf(_joints, i);
            _tracks = new TruthTrack[_joints.Length];
            _frames = new ShownFrames(_joints.Length);
            _values = new ShownFrames.JointValues[_joints.Length];
            _speeds = new TrueSpeeds(_joints.Length);
            _ofJoint = new ErrorWindow[_joints.Length];
            for (var i = 0; i < _ofJoint.Length; i++) _ofJoint[i] = new ErrorWindow();
            _isEndless = new bool[_joints.Length];
            for (var i = 0; i < _isEndless.Length; i++)
                _isEndless[i] = JointTracks.BoundsOf(robot.MovingJoints[_joints[i]], settings).IsEndless;
        }

        /// <summary>Raised within <see cref="Add"/> for each scored frame, with its display time, its state, and its tool error in m.</summary>
        public event Action<ControlTime, PoseState, ErrorSums> ToolJudged;

        /// <summary>Number of joints between base and tool, without mimic joints.</summary>
        public int JointCount { get; }

        /// <summary>Errors of the tool over the last ten seconds, m; null while unknown, and while <see cref="Withheld"/> has a reason.</summary>
        public DisplayedError? Tool => IsKnown && IsToolKnown ? _tool.Read(_now.Value) : null;

        /// <summary>
        /// Errors of the tool since <see cref="RestartRun"/>, m; null while unknown, and if <see cref="WithheldOfRun"/> has a reason.
        /// </summary>
        public DisplayedError? ToolOfRun => WithheldOfRun == ErrorWithheldReason.None ? _toolOfRun.Read() : null;

        /// <summary>Reason why the current errors are withheld.</summary>
        public ErrorWithheldReason Withheld { get; private set; }

        /// <summary>Reason why the errors of the run are withheld, which is the reason for the first frame that cannot be scored.</summary>
        public ErrorWithheldReason WithheldOfRun => IsRunKnown ? _withheldOfRun : Withheld;

        bool IsRunKnown => _hasRunBegun && (_withheldOfRun != ErrorWithheldReason.None || _toolOfRun.Read().HasValue);

        bool IsKnown => _now.HasValue && (IsToolKnown || Withheld == ErrorWithheldReason.MovingBase);

        bool IsToolKnown => Withheld == ErrorWithheldReason.None;

        /// <summary>Returns the errors of one joint over the last ten seconds, rad or m; joints are in the order from the base.</summary>
        public JointError JointAt(int index) => new JointError(
            _robot.MovingJoints[_joints[index]].Name, IsKnown ? _ofJoint[index].Read(_now.Value) : null);

        /// <summary>Adds a displayed frame. A frame without a trusted display time cannot be scored and makes the current errors unknown.</summary>
        /// <param name="given">For each moving joint of the robot that is a mimic joint: whether it has the position of its own samples.</param>
        /// <param name="clockError">Error bound of the clock.</param>
        /// <param name="isBaseMoving">Whether the robot's base can move, so that the error of the tool in the base does not include that of the base.</param>
        public void Shown(DisplayFrame frame, ReadOnlySpan<bool> given, TimeSpan clockError, bool isBaseMoving)
        {
            _now = frame.IsTimeTrusted ? frame.DisplayTime : null;
            Withheld = isBaseMoving && frame.ErrorWithheld == ErrorWithheldReason.None ? ErrorWithheldReason.MovingBase : frame.ErrorWithheld;
            if (_now == null || frame.State == PoseState.Incomplete) return;
            // The first frames of a session have no render time, because its source has not been found yet.
            _hasRunBegun |= Withheld != ErrorWithheldReason.OtherSource && Withheld != ErrorWithheldReason.NoRenderTime;
            if (_hasRunBegun && _withheldOfRun == ErrorWithheldReason.None && Withheld != ErrorWithheldReason.LowFrameRate) _withheldOfRun = Withheld;
            if (!IsKnown) return;
            var needed = FollowMimics(given);
            for (var i = 0; i < _tracks.Length; i++)
                if (_isNeeded[i] && !(_tracks[i].CompleteUntil < _now.Value)) return;
            var values = _frames.Add(
                _now.Value, frame.State, IsToolKnown, frame.ToolPose, _kinematics.ToolOf(frame.HeldJoints), ClockTicks.Seconds(clockError), needed);
            for (var i = 0; i < _joints.Length; i++)
            {
                values[i].Displayed = frame.Joints[_joints[i]];
                values[i].Held = frame.HeldJoints[_joints[i]];
            }
        }

        // Returns the number of joints whose true positions are needed.
        int FollowMimics(ReadOnlySpan<bool> given)
        {
            var needed = JointCount;
            for (var i = JointCount; i < _joints.Length; i++)
            {
                var isGiven = given[_joints[i]];
                if (isGiven) needed++;
                if (_isNeeded[i] == isGiven) continue;
                _isNeeded[i] = isGiven;
                _kinematics.SetGiven(_joints[i], isGiven);
                // All waiting frames need the true positions of the same joints.
                _frames.Clear();
            }
            return needed;
        }

        /// <summary>Adds received samples, which determine the true positions of earlier frames.</summary>
        /// <param name="joints">
        /// Index among the robot's moving joints for each joint of the message; negative for a joint that the robot does not have.
        /// </param>
        public void Add(JointStateMessage message, ReadOnlySpan<int> joints)
        {
            for (var i = 0; i < joints.Length; i++)
            {
                var place = joints[i] >= 0 ? _placeOfJoint[joints[i]] : -1;
                // The whole turns of a corrupt angle cannot be removed from the next angles.
                if (place < 0 || !(Math.Abs(message.Positions[i]) < JointSample.MaxMagnitude)) continue;
                ref var track = ref _tracks[place];
                var position = _isEndless[place] ? track.Unwrapped(message.Positions[i]) : message.Positions[i];
                if (track.Add(new TruthSample(message.Stamp, position), _maximumGap, out var span, out var isKnown) && _isNeeded[place])
                    _frames.SetTruth(place, span, isKnown);
            }
            while (_frames.TryTakeFirst(out var frame, _values)) Judge(frame);
        }

        /// <summary>Resets a joint whose stamps went back; its next samples cannot be compared with the earlier samples.</summary>
        /// <param name="joint">Index among the robot's moving joints.</param>
        public void Restart(int joint)
        {
            if (_placeOfJoint[joint] < 0) return;
            _tracks[_placeOfJoint[joint]] = default;
            // Otherwise, the waiting frames would receive the true position of this joint twice or not at all.
            _frames.Clear();
        }

        /// <summary>Starts a new run with the next frame.</summary>
        public void RestartRun()
        {
            _runSince = _now;
            _hasRunBegun = false;
            _withheldOfRun = ErrorWithheldReason.None;
            _toolOfRun.Reset();
        }

        /// <summary>Resets everything except the errors over the whole run, because earlier times can no longer be compared with new times.</summary>
        public void Reset()
        {
            Array.Clear(_tracks, 0, _tracks.Length);
            _frames.Clear();
            _tool.Reset();
            foreach (var joint in _ofJoint) joint.Reset();
            _speeds.Reset();
            _now = _runSince = null;
        }

        void Judge(in ShownFrames.Frame frame)
        {
            _speeds.Next(frame.At);
            for (var i = 0; i < _joints.Length; i++)
            {
                if (!_isNeeded[i]) continue;
                ref var joint = ref _values[i];
                var speed = _speeds.OfJoint(i, joint.Truth);
                // The displayed angle of a continuous joint is in the turn of the newest sample that the display had.
                if (_isEndless[i]) joint.Truth -= JointPredictor.WholeTurns(joint.Truth - joint.Displayed);
                _ofJoint[i].Add(frame.At, new ErrorSums(
                    Square(joint.Displayed - joint.Truth), Square(joint.Held - joint.Truth), Square(joint.Uncertainty),
                    Square(frame.ClockError * speed)));
            }
            var truth = _kinematics.ToolOf(_values, false);
            var toolSpeed = _speeds.OfTool(truth);
            if (!frame.IsToolKnown) return;
            var uncertain = _kinematics.ToolOf(_values, true);
            var error = new ErrorSums(
                Square(frame.X - truth.X) + Square(frame.Y - truth.Y) + Square(frame.Z - truth.Z),
                Square(frame.HeldX - truth.X) + Square(frame.HeldY - truth.Y) + Square(frame.HeldZ - truth.Z),
                Square(uncertain.X - truth.X) + Square(uncertain.Y - truth.Y) + Square(uncertain.Z - truth.Z),
                Square(frame.ClockError * toolSpeed));
            if (!_tool.Add(frame.At, error)) return;
            // Otherwise, the frame was shown before the run started.
            if (!(frame.At <= _runSince)) _toolOfRun.Add(error);
            ToolJudged?.Invoke(frame.At, frame.State, error);
        }

        static double Square(double x) => x * x;
    }
}
