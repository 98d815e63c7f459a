using System;
using System.Collections.Generic;

namespace Nowpose.Protocol
{
    /// <summary>sensor_msgs/JointState: where some joints were at one control time. May carry a subset of a robot's joints.</summary>
    /// <remarks>
    /// The arrays belong to the message; users only read them. A message that a <see cref="RosbridgeReader"/> read and a session received is
    /// reused for a later one when the session has taken its samples and has no handler that may keep it.
    /// </remarks>
    public sealed class JointStateMessage
    {
        readonly JointStatePool _pool;
        double[] _velocities;
        double[] _accelerations;

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

        /// <summary>A message to be filled.</summary>
        internal JointStateMessage(int joints, JointStatePool pool)
        {
            Positions = new double[joints];
            _pool = pool;
        }

        /// <summary>t_k: when the joints were there, on the control clock C1.</summary>
        public ControlTime Stamp { get; private set; }

        /// <summary>The same array as of the message before where its source repeats them.</summary>
        public string[] Names { get; private set; }

        /// <summary>rad or m, one for each name.</summary>
        public double[] Positions { get; }

        /// <summary>rad/s or m/s, one for each name, NaN where absent; null when none is known.</summary>
        public double[] Velocities { get; private set; }

        /// <summary>
        /// rad/s² or m/s², one for each name, NaN where absent; null when none is known. Beyond sensor_msgs: for control
        /// systems that publish their set-points.
        /// </summary>
        public double[] Accelerations { get; private set; }

        /// <summary>Of what a headset shows: its name. Empty elsewhere.</summary>
        public string FrameId { get; private set; }

        /// <summary>The same positions at another time; shares the arrays.</summary>
        public JointStateMessage At(ControlTime stamp) =>
            new JointStateMessage(stamp, Names, Positions, Velocities, Accelerations, FrameId);

        /// <summary>Overwrites all of it. Of the lists, velocities and accelerations may be empty; the others have an element per joint.</summary>
        internal void Fill(
            ControlTime stamp, string[] names, List<double> positions, List<double> velocities, List<double> accelerations, string frameId)
        {
            Stamp = stamp;
            Names = names;
            positions.CopyTo(Positions);
            Velocities = Filled(ref _velocities, velocities);
            Accelerations = Filled(ref _accelerations, accelerations);
            FrameId = frameId;
        }

        /// <summary>Returns the message to its reader, which reuses it: the caller is its last user. Does nothing for a message that was not read.</summary>
        internal void Release() => _pool?.Return(this);

        static double[] Filled(ref double[] array, List<double> values)
        {
            if (values.Count == 0) return null;
            if (array == null) array = new double[values.Count];
            values.CopyTo(array);
            return array;
        }
    }
}
