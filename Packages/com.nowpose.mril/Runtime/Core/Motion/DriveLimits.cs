using Nowpose.Kinematics;

namespace Nowpose.Motion
{
    /// <summary>How fast one joint is driven, in rad or m and seconds.</summary>
    readonly struct DriveLimits
    {
        // Programmed speeds leave some of the rated one to the drives.
        const double SpeedShare = 0.9;

        // A small arm reaches its speed of about 1.5 rad/s in half a second, which is what makers of arms of this size give as
        // usual for moves with a load (UR5: 1.4 rad/s² preset, several times that possible), and its drives build up
        // acceleration within 0.1 s so that the arm does not ring: 3 rad/s², 30 rad/s³.
        static readonly DriveLimits Revolute = new DriveLimits(1.0, 3, 30);

        // A gripper or short axis: its stroke of a centimetre takes a few tenths of a second.
        static readonly DriveLimits Prismatic = new DriveLimits(0.25, 0.5, 10);

        DriveLimits(double velocity, double acceleration, double jerk)
        {
            Velocity = velocity;
            Acceleration = acceleration;
            Jerk = jerk;
        }

        public double Velocity { get; }
        public double Acceleration { get; }
        public double Jerk { get; }

        /// <summary>From the URDF where it limits the speed, else what suits a small robot.</summary>
        public static DriveLimits Of(RobotJoint joint)
        {
            var usual = joint.Kind == JointKind.Prismatic ? Prismatic : Revolute;
            var rated = joint.Limits.Velocity;
            return double.IsInfinity(rated) ? usual : new DriveLimits(rated * SpeedShare, usual.Acceleration, usual.Jerk);
        }
    }
}
