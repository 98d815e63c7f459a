using System;

namespace Nowpose.Protocol
{
    /// <summary>sensor_msgs/JointState: where some joints were at one control time. May carry a subset of a robot's joints.</summary>
    /// <remarks>The arrays belong to the message: whoever holds it reads them only.</remarks>
    public sealed class JointStateMessage
    {
        /// <param name="positions">rad or m, as many as <paramref name="names"/>, finite.</param>
        /// <param name="velocities">rad/s or m/s, as many as <paramref name="names"/>, NaN where absent; null when all are.</param>
        /// <param name="accelerations">rad/s² or m/s², as many as <paramref name="names"/>, NaN where absent; null when all are.</param>
        /// <param name="frameId">See <see cref="FrameId"/>.</param>
        /// <exception cref="ArgumentException">The lengths differ.</exception>
        public JointStateMessage(
            ControlTime stamp, string[] names, double[] positions, double[] velocities = null, double[] accelerations = null,
            string frameId = "")
        {
            if (positions.Length != names.Length)
                throw new ArgumentException(positions.Length + " positions for " + names.Length + " joints", nameof(positions));
            if (velocities != null && velocities.Length != names.Length)
                throw new ArgumentException(velocities.Length + " velocities for " + names.Length + " joints", nameof(velocities));
            if (accelerations != null && accelerations.Length != names.Length)
                throw new ArgumentException(accelerations.Length + " accelerations for " + names.Length + " joints", nameof(accelerations));
            Stamp = stamp;
            Names = names;
            Positions = positions;
            Velocities = velocities;
            Accelerations = accelerations;
            FrameId = frameId;
        }

        /// <summary>t_k: when the joints were there, on the control clock C1.</summary>
        public ControlTime Stamp { get; }

        public string[] Names { get; }

        /// <summary>rad or m, one for each name.</summary>
        public double[] Positions { get; }

        /// <summary>rad/s or m/s, one for each name, NaN where absent; null when none is known.</summary>
        public double[] Velocities { get; }

        /// <summary>
        /// rad/s² or m/s², one for each name, NaN where absent; null when none is known. Beyond sensor_msgs: for control
        /// systems that publish their set-points.
        /// </summary>
        public double[] Accelerations { get; }

        /// <summary>Of what a headset shows: its name. Empty elsewhere.</summary>
        public string FrameId { get; }

        /// <summary>The same positions at another time; shares the arrays.</summary>
        public JointStateMessage At(ControlTime stamp) =>
            new JointStateMessage(stamp, Names, Positions, Velocities, Accelerations, FrameId);
    }
}
