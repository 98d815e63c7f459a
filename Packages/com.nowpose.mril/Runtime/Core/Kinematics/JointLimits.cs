using System;

namespace Nowpose.Kinematics
{
    /// <summary>What a joint can do, in rad, s and N·m, for a prismatic joint in m, s and N; infinite where nothing limits it.</summary>
    /// <remarks><c>default</c> allows no motion at all; <see cref="None"/> allows everything.</remarks>
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

        /// <summary>Least position; never above <see cref="Upper"/>.</summary>
        public double Lower { get; }

        public double Upper { get; }

        /// <summary>Greatest speed in either direction, above 0.</summary>
        public double Velocity { get; }

        /// <summary>Greatest force or torque in either direction.</summary>
        public double Effort { get; }

        /// <summary>Greatest acceleration in either direction, above 0; not part of most URDFs.</summary>
        public double Acceleration { get; }

        /// <summary>Greatest jerk in either direction, above 0; not part of most URDFs.</summary>
        public double Jerk { get; }

        /// <summary>Whether the joint turns without end: its angle may come back from π to −π.</summary>
        public bool IsEndless { get; }

        public bool Contains(double position) => position >= Lower && position <= Upper;

        public double Clamp(double position) => Math.Min(Math.Max(position, Lower), Upper);
    }
}
