using System;

namespace Nowpose.Protocol
{
    /// <summary>One set-point of a trajectory.</summary>
    sealed class JointTrajectoryPoint
    {
        public JointTrajectoryPoint(TimeSpan timeFromStart, double[] positions, double[] velocities = null, double[] accelerations = null)
        {
            TimeFromStart = timeFromStart;
            Positions = positions;
            Velocities = velocities;
            Accelerations = accelerations;
        }

        /// <summary>Time after the trajectory's stamp.</summary>
        public TimeSpan TimeFromStart { get; }

        /// <summary>Positions in rad or m, one for each joint of the trajectory.</summary>
        public double[] Positions { get; }

        /// <summary>Velocities in rad/s or m/s, NaN if unknown; null if all are unknown.</summary>
        public double[] Velocities { get; }

        /// <summary>Accelerations in rad/s² or m/s², NaN if unknown; null if all are unknown.</summary>
        public double[] Accelerations { get; }
    }
}
