using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>Creates messages with the joints of the newest frame. Not thread-safe.</summary>
    sealed class DisplayedJoints
    {
        readonly DisplayFrame _frame;
        readonly string[] _names;
        readonly string _headset;
        ControlTime _newest;

        /// <param name="name">Namespace of the robot; empty for the robot without a namespace. The topic is common to all robots.</param>
        public DisplayedJoints(string name, RobotModel robot, DisplayFrame frame, string headset)
        {
            _frame = frame;
            _names = robot.MovingJoints.Select(joint => RobotTopic.Qualified(name, joint.Name)).ToArray();
            _headset = headset;
        }

        /// <summary>
        /// Returns the joints of the newest frame, stamped with its display time. Null while the display time is unknown or too inaccurate,
        /// while a joint of the arm has no sample, and if this frame was already returned.
        /// </summary>
        public JointStateMessage Take()
        {
            if (!(_frame.DisplayTime is ControlTime displayTime) || !_frame.IsTimeTrusted || _frame.State == PoseState.Incomplete) return null;
            if (displayTime == _newest) return null;
            _newest = displayTime;
            return new JointStateMessage(displayTime, _names, _frame.Joints.ToArray(), frameId: _headset);
        }
    }
}
