using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Messages;
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
                throw new InputException(RobotMessages.TooManyJoints(robot.Name, robot.MovingJoints.Count, ProtocolLimits.Joints));
            return robot.MovingJoints.Select(joint => joint.Name).ToArray();
        }
    }
}
