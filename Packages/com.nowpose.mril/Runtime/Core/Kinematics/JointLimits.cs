using System;

namespace Nowpose.Kinematics
{
    /// <summary>Limits of a joint in units of rad, s and N·m, or m, s and N for a prismatic joint. A missing limit is infinite.</summary>
    /// <remarks><c>default</c> allows no motion; <see cref="None"/> allows every motion.</remarks>
    public readonly struct JointLimits
    {
        public JointLimits(
            double lower, double upper, double velocity, double effort, double acceleration = double.PositiveInfinity,
            double jerk = double.PositiveInfinity, bool isEndless = false)
        {
            Lower = lower;
            Upper = upper;
            Velocity = velocity;
            Effort = effort;
            Acceleration = acceleration;
            Jerk = jerk;
            IsEndless = isEndless;
        }

        public static JointLimits None { get; } = new JointLimits(
            double.NegativeInfinity, double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity);

        /// <summary>Minimum position; never above <see cref="Upper"/>.</summary>
        public double Lower { get; }

        public double Upper { get; }

        /// <summary>Maximum speed in either direction, above 0.</summary>
        public double Velocity { get; }

        /// <summary>Maximum force or torque in either direction.</summary>
        public double Effort { get; }

        /// <summary>Maximum acceleration in either direction, above 0; not part of most URDFs.</summary>
        public double Acceleration { get; }

        /// <summary>Maximum jerk in either direction, above 0; not part of most URDFs.</summary>
        public double Jerk { get; }

        /// <summary>
        /// Whether positions are angles of a continuous joint, which may wrap from π to −π. False in the limits that a URDF states;
        /// <see cref="Session.PredictionSettings.Bounded"/> sets it for a revolute joint without position limits.
        /// </summary>
        public bool IsEndless { get; }

        public bool Contains(double position) => position >= Lower && position <= Upper;

        public double Clamp(double position) => Math.Min(Math.Max(position, Lower), Upper);
    }
}
