using Nowpose.Kinematics;

namespace Nowpose.Motion
{
    /// <summary>Limits of one joint's simulated drive, in rad or m and seconds.</summary>
    readonly struct DriveLimits
    {
        // Programmed speeds leave a part of the rated speed in reserve.
        const double SpeedShare = 0.9;

        // Acceleration: with a load, a small arm usually reaches its speed of about 1.5 rad/s within half a second, at 3 rad/s² (the preset of
        // the UR5 is 1.4 rad/s², and several times that value is possible). Jerk: the drives build up the acceleration within 0.1 s to
        // avoid vibration, at 30 rad/s³.
        static readonly DriveLimits Revolute = new DriveLimits(1.0, 3, 30);

        // For a gripper or short axis: a stroke of a centimetre takes a few tenths of a second.
        static readonly DriveLimits Prismatic = new DriveLimits(0.25, 0.5, 10);

        DriveLimits(double velocity, double acceleration, double jerk) => (Velocity, Acceleration, Jerk) = (velocity, acceleration, jerk);

        public double Velocity { get; }
        public double Acceleration { get; }
        public double Jerk { get; }

        /// <summary>Returns limits with the speed that the URDF specifies, or with the speed of a small robot if the URDF specifies none.</summary>
        public static DriveLimits Of(RobotJoint joint)
        {
            var usual = joint.Kind == JointKind.Prismatic ? Prismatic : Revolute;
            var rated = joint.Limits.Velocity;
            return double.IsInfinity(rated) ? usual : new DriveLimits(rated * SpeedShare, usual.Acceleration, usual.Jerk);
        }
    }
}
