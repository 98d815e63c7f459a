using System;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Protocol;

namespace Nowpose.Session.Hindcast
{
    /// <summary>
    /// How far the tool, and each joint it hangs on, was displayed from where it truly was, as the samples that came later tell; of
    /// the hold likewise.
    /// </summary>
    /// <remarks>
    /// The truth at a display time is the forward kinematics of the joints on the curves through their samples around, judged
    /// when the second sample after it has come. It can be no better than the samples: what they all share, an error of the
    /// clock or of L_visu, it cannot see. Allocates nothing once made; one thread.
    /// </remarks>
    sealed class HindcastMonitor
    {
        readonly RobotModel _robot;
        readonly HindcastKinematics _kinematics;
        readonly TimeSpan _maximumGap;
        readonly int[] _joints;
        readonly int[] _placeOfJoint;
        readonly TruthTrack[] _tracks;
        readonly ShownFrames _frames;
        readonly ErrorRecord _tool = new ErrorRecord();
        readonly ErrorRecord[] _ofJoint;
        readonly ShownFrames.JointValues[] _values;
        readonly TrueSpeeds _speeds;
        ControlTime? _now;
        ControlTime? _runSince;

        /// <param name="maximumGap">Between samples that lie further apart nobody knows how the robot moved.</param>
        public HindcastMonitor(RobotModel robot, TimeSpan maximumGap)
        {
            _robot = robot;
            _maximumGap = maximumGap;
            _joints = ToolJoints.Of(robot);
            _kinematics = new HindcastKinematics(robot, _joints);
            _placeOfJoint = new int[robot.MovingJoints.Count];
            for (var i = 0; i < _placeOfJoint.Length; i++) _placeOfJoint[i] = Array.IndexOf(_joints, i);
            _tracks = new TruthTrack[_joints.Length];
            _frames = new ShownFrames(_joints.Length);
            _values = new ShownFrames.JointValues[_joints.Length];
            _speeds = new TrueSpeeds(_joints.Length);
            _ofJoint = new ErrorRecord[_joints.Length];
            for (var i = 0; i < _ofJoint.Length; i++) _ofJoint[i] = new ErrorRecord();
        }

        /// <summary>A frame shown before was judged: its display time, its state, and the error of its tool in m. Raised within <see cref="Add"/>.</summary>
        public event Action<ControlTime, PoseState, ErrorSample> ToolJudged;

        /// <summary>Joints between base and tool that have samples of their own, from the base on.</summary>
        public int JointCount => _joints.Length;

        /// <summary>Of the tool over the newest ten seconds, m; null while unknown.</summary>
        public DisplayedError? Tool => _now.HasValue ? _tool.Now(_now.Value) : null;

        /// <summary>Of the tool since <see cref="RestartRun"/>, m; null while unknown.</summary>
        public DisplayedError? ToolOfRun => _tool.OfRun;

        /// <summary>Of one joint over the newest ten seconds, rad or m.</summary>
        public JointError JointAt(int index) => new JointError(
            _robot.MovingJoints[_joints[index]].Name, _now.HasValue ? _ofJoint[index].Now(_now.Value) : null);

        /// <summary>A frame as it is displayed. Without a trusted time nothing is known of it, nor of the error now.</summary>
        /// <param name="clockError">Bound of the clock's error.</param>
        public void Shown(DisplayFrame frame, TimeSpan clockError)
        {
            _now = frame.IsTimeTrusted ? frame.DisplayTime : null;
            // Outside the range the light appears at another time than the display time.
            if (_now == null || frame.State == PoseState.Incomplete || frame.Range == RangeState.Outside) return;
            foreach (ref readonly var track in _tracks.AsSpan())
                if (!(track.ToldUntil < _now.Value)) return;
            var values = _frames.Add(_now.Value, frame.State, frame.ToolPose, _kinematics.ToolOf(frame.HeldJoints), ClockTicks.Seconds(clockError));
            for (var i = 0; i < _joints.Length; i++)
            {
                values[i].Displayed = frame.Joints[_joints[i]];
                values[i].Held = frame.HeldJoints[_joints[i]];
            }
        }

        /// <summary>Samples that have arrived: they tell the truth about frames shown before.</summary>
        /// <param name="joints">Indices of the message's joints among the robot's moving joints; negative for others.</param>
        public void Add(JointStateMessage message, ReadOnlySpan<int> joints)
        {
            for (var i = 0; i < joints.Length; i++)
            {
                var place = joints[i] >= 0 ? _placeOfJoint[joints[i]] : -1;
                if (place >= 0 && _tracks[place].Add(
                    new TruthSample(message.Stamp, message.Positions[i]), _maximumGap, out var span, out var isKnown))
                    _frames.Tell(place, span, isKnown);
            }
            while (_frames.TryTakeFirst(out var frame, _values)) Judge(frame);
        }

        /// <summary>A joint's source went back in time: its samples from now on lie on another time line than those before.</summary>
        /// <param name="joint">Index among the robot's moving joints.</param>
        public void StartAnew(int joint)
        {
            if (_placeOfJoint[joint] < 0) return;
            _tracks[_placeOfJoint[joint]] = default;
            // Of those that wait, the joint would tell some twice and others never.
            _frames.Clear();
        }

        /// <summary>From the next frame on, the errors of a new run are counted.</summary>
        public void RestartRun()
        {
            _runSince = _now;
            _tool.RestartRun();
        }

        /// <summary>Forgets all but the run: times of before belong to another time line.</summary>
        public void Reset()
        {
            Array.Clear(_tracks, 0, _tracks.Length);
            _frames.Clear();
            _tool.ResetWindow();
            foreach (var joint in _ofJoint) joint.ResetWindow();
            _speeds.Reset();
            _now = _runSince = null;
        }

        void Judge(in ShownFrames.Frame frame)
        {
            var isOfRun = !(frame.At <= _runSince);
            _speeds.Next(frame.At);
            for (var i = 0; i < _joints.Length; i++)
            {
                ref readonly var joint = ref _values[i];
                _ofJoint[i].Add(frame.At, new ErrorSample(
                    Square(joint.Displayed - joint.Truth), Square(joint.Held - joint.Truth), Square(joint.Doubt),
                    Square(frame.ClockError * _speeds.OfJoint(i, joint.Truth))), isOfRun);
            }
            var truth = _kinematics.ToolOf(_values, false);
            var doubted = _kinematics.ToolOf(_values, true);
            var error = new ErrorSample(
                Square(frame.X - truth.X) + Square(frame.Y - truth.Y) + Square(frame.Z - truth.Z),
                Square(frame.HeldX - truth.X) + Square(frame.HeldY - truth.Y) + Square(frame.HeldZ - truth.Z),
                Square(doubted.X - truth.X) + Square(doubted.Y - truth.Y) + Square(doubted.Z - truth.Z),
                Square(frame.ClockError * _speeds.OfTool(truth)));
            _tool.Add(frame.At, error, isOfRun);
            ToolJudged?.Invoke(frame.At, frame.State, error);
        }

        static double Square(double x) => x * x;
    }
}
