using System.Globalization;

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

        /// <summary>A message of one line with the joint, its position, its limits and the possible causes.</summary>
        public string Words { get; }

        static string WordsOf(RobotJoint joint, double position)
        {
            var (unit, other) = joint.Kind == JointKind.Prismatic ? ("m", "mm") : ("rad", "degrees");
            return string.Format(
                CultureInfo.InvariantCulture,
                "joint '{0}': {1:0.###} {4} is outside its limits {2:0.###} to {3:0.###} {4}, and is drawn at the limit; "
                + "check that the robot description belongs to this robot and that the source sends {4}, not {5}",
                joint.Name, position, joint.Limits.Lower, joint.Limits.Upper, unit, other);
        }
    }
}
