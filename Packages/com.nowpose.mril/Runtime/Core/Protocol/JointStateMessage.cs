using System;

namespace Nowpose.Protocol
{
    /// <summary>sensor_msgs/JointState: where some joints were at one control time. May carry a subset of a robot's joints.</summary>
    /// <remarks>The arrays belong to the message: whoever holds it reads them only.</remarks>
    public sealed class JointStateMessage
    {
        /// <param name="positions">rad or m, as many as <paramref name="names"/>, finite.</param>
        /// <param name="velocities">rad/s or m/s, as many as <paramref name="names"/>, NaN where absent; null when all are.</param>
        /// <exception cref="ArgumentException">The lengths differ.</exception>
        public JointStateMessage(ControlTime stamp, string[] names, double[] positions, double[] velocities = null)
        {
            if (positions.Length != names.Length)
                throw new ArgumentException(positions.Length + " positions for " + names.Length + " joints", nameof(positions));
            if (velocities != null && velocities.Length != names.Length)
                throw new ArgumentException(velocities.Length + " velocities for " + names.Length + " joints", nameof(velocities));
            Stamp = stamp;
            Names = names;
            Positions = positions;
            Velocities = velocities;
        }

        /// <summary>t_k: when the joints were there, on the control clock C1.</summary>
        public ControlTime Stamp { get; }

        public string[] Names { get; }

        /// <summary>rad or m, one for each name.</summary>
        public double[] Positions { get; }

        /// <summary>rad/s or m/s, one for each name, NaN where absent; null when none is known.</summary>
        public double[] Velocities { get; }
    }
}
