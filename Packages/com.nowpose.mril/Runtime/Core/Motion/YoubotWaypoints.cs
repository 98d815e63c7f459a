using System.Linq;
using Nowpose.Kinematics;

namespace Nowpose.Motion
{
    /// <summary>Waypoints of the youBot's pick-and-place cycle, which begins and ends at the home position.</summary>
    static class YoubotWaypoints
    {
        const double Open = 0.0115;
        const double Closed = 0.002;

        static readonly string[] Joints =
        {
            "arm_joint_1", "arm_joint_2", "arm_joint_3", "arm_joint_4", "arm_joint_5", "gripper_finger_joint_l",
        };

        // Joint positions, rad. Joints 2 to 4 point the gripper straight down. Distance of the palm from joint 1's axis and height above
        // the base: 220 and 90 mm at the pick, 220 and 150 mm above the pick, 200 and 110 mm at the place, 200 and 150 mm above the place.
        // The arm is upright at 1.1345, -2.5482, 1.7890. It points forward at joint 1 = 2.9671, and turns 1.3 rad to one side for the pick
        // and 1.5 rad to the other for the place.
        static readonly double[] Home = { 2.9671, 0.8345, -1.3482, 2.9890, 2.9234 };
        static readonly double[] AbovePick = { 1.6671, 1.4863, -1.4741, 3.5047, 2.9234 };
        static readonly double[] Pick = { 1.6671, 1.5160, -1.0670, 3.0678, 2.9234 };
        static readonly double[] AbovePlace = { 4.4671, 1.3469, -1.2898, 3.4598, 1.3526 };
        static readonly double[] Place = { 4.4671, 1.3592, -1.0076, 3.1652, 1.3526 };

        static readonly (double[] Arm, double Finger)[] Cycle =
        {
            (Home, Open), (AbovePick, Open), (Pick, Open), (Pick, Closed), (AbovePick, Closed),
            (AbovePlace, Closed), (Place, Closed), (Place, Open), (AbovePlace, Open),
        };

        /// <summary>The arm waits above the pick and above the place. Its fingers close and open at the waypoints between these.</summary>
        public static readonly TaskMoves Task = new TaskMoves(approach: 1, grip: 2, lower: 5, release: 6);

        public static bool Fits(RobotModel robot) => Joints.All(name => robot.IndexOfMovingJoint(name) >= 0);

        public static double[][] Of(RobotModel robot) =>
            Cycle.Select(point => Positions(robot, point.Arm.Append(point.Finger).ToArray())).ToArray();

        static double[] Positions(RobotModel robot, double[] values)
        {
            var positions = new double[robot.MovingJoints.Count];
            for (var i = 0; i < Joints.Length; i++)
                positions[robot.IndexOfMovingJoint(Joints[i])] = values[i];
            return positions;
        }
    }
}
