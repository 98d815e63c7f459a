using Nowpose.Messages;

namespace Nowpose.Kinematics
{
    /// <summary>A joint whose received position is outside its limits. Immutable.</summary>
    public sealed class JointBeyondLimits
    {
        internal JointBeyondLimits(RobotJoint joint, double position)
        {
            Joint = joint;
            Position = position;
            Words = WordsOf(joint, position);
        }

        public RobotJoint Joint { get; }

        /// <summary>Position at the time of detection, in rad or m.</summary>
        public double Position { get; }

        /// <summary>One-line message with the joint, its position, its limits and the possible causes.</summary>
        public string Words { get; }

        static string WordsOf(RobotJoint joint, double position)
        {
            var (unit, other) = joint.Kind == JointKind.Prismatic ? ("m", "mm") : ("rad", "degrees");
            return RobotMessages.BeyondLimits(joint.Name, position, unit, joint.Limits.Lower, joint.Limits.Upper, other);
        }
    }
}
