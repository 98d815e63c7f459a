using System;
using System.Collections.Generic;
using Newtonsoft.Json;
using Nowpose.Messages;

namespace Nowpose.Protocol
{
    /// <summary>sensor_msgs/JointState: positions of some joints at one control time. May contain a subset of a robot's joints.</summary>
    /// <remarks>
    /// The arrays belong to the message; users only read them. A message from a <see cref="RosbridgeReader"/> is reused after the session
    /// has used its samples, unless a handler may keep the message.
    /// </remarks>
    public sealed class JointStateMessage : IRosMessage
    {
        readonly MessagePool<JointStateMessage> _pool;
        double[] _velocities;
        double[] _accelerations;

        /// <param name="positions">Positions in rad or m, one per name; finite.</param>
        /// <param name="velocities">Velocities in rad/s or m/s, one per name, NaN if unknown; null if all are unknown.</param>
        /// <param name="accelerations">Accelerations in rad/s² or m/s², one per name, NaN if unknown; null if all are unknown.</param>
        /// <param name="frameId">See <see cref="FrameId"/>.</param>
        /// <exception cref="ArgumentException">The lengths differ.</exception>
        public JointStateMessage(
            ControlTime stamp, string[] names, double[] positions, double[] velocities = null, double[] accelerations = null,
            string frameId = "")
        {
            if (positions.Length != names.Length)
                throw new ArgumentException(ProtocolMessages.PositionCount(positions.Length, names.Length), nameof(positions));
            if (velocities != null && velocities.Length != names.Length)
                throw new ArgumentException(ProtocolMessages.VelocityCount(velocities.Length, names.Length), nameof(velocities));
            if (accelerations != null && accelerations.Length != names.Length)
                throw new ArgumentException(ProtocolMessages.AccelerationCount(accelerations.Length, names.Length), nameof(accelerations));
            Stamp = stamp;
            Names = names;
            Positions = positions;
            Velocities = velocities;
            Accelerations = accelerations;
            FrameId = frameId;
        }

        /// <summary>Constructs an empty message that <see cref="Fill"/> completes.</summary>
        internal JointStateMessage(int joints, MessagePool<JointStateMessage> pool)
        {
            Positions = new double[joints];
            _pool = pool;
        }

        /// <summary>t_k: time of the positions, on the control clock C1.</summary>
        public ControlTime Stamp { get; private set; }

        /// <summary>Joint names; the same array as in the previous message if its source repeats them.</summary>
        public string[] Names { get; private set; }

        /// <summary>Positions in rad or m, one for each name.</summary>
        public double[] Positions { get; }

        /// <summary>Velocities in rad/s or m/s, one for each name, NaN if unknown; null if all are unknown.</summary>
        public double[] Velocities { get; private set; }

        /// <summary>
        /// Accelerations in rad/s² or m/s², one for each name, NaN if unknown; null if all are unknown. The field extends
        /// sensor_msgs/JointState, for control systems that publish their set-points.
        /// </summary>
        public double[] Accelerations { get; private set; }

        /// <summary>Name of the headset in a message of displayed joints; otherwise empty.</summary>
        public string FrameId { get; private set; }

        /// <summary>Returns whether two messages have the same joints in the same order.</summary>
        internal static bool HaveSameNames(JointStateMessage a, JointStateMessage b) => a.Names == b.Names || a.Names.AsSpan().SequenceEqual(b.Names);

        /// <summary>Returns the same positions at another time; shares the arrays.</summary>
        public JointStateMessage At(ControlTime stamp) =>
            new JointStateMessage(stamp, Names, Positions, Velocities, Accelerations, FrameId);

        /// <summary>
        /// Overwrites all values. The lists of velocities and accelerations may be empty; the other lists have one element per joint.
        /// </summary>
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

        void IRosMessage.Write(JsonWriter json, RosTimeForm form)
        {
            json.WriteStartObject();
            json.Header(Stamp, form, FrameId);
            json.Texts("name", Names);
            json.Numbers("position", Positions);
            json.OptionalNumbers("velocity", Velocities);
            json.Numbers("effort", Array.Empty<double>());
            if (Accelerations != null) json.OptionalNumbers("acceleration", Accelerations);
            json.WriteEndObject();
        }

        /// <summary>
        /// Returns the message to its reader for reuse. Only the last user may call it. Does nothing if no reader created the message.
        /// </summary>
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
