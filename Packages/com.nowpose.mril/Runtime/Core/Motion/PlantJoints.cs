using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Protocol;

namespace Nowpose.Motion
{
    /// <summary>The joints that a plant publishes: all moving joints, including mimic joints.</summary>
    static class PlantJoints
    {
        /// <exception cref="InputException">The robot has more moving joints than one message can contain.</exception>
        public static string[] NamesOf(RobotModel robot)
        {
            if (robot.MovingJoints.Count > ProtocolLimits.Joints)
                throw new InputException("robot " + robot.Name + ": has " + robot.MovingJoints.Count + " moving joints; "
                    + "a message carries at most " + ProtocolLimits.Joints + "; make some of them fixed");
            return robot.MovingJoints.Select(joint => joint.Name).ToArray();
        }
    }
}
