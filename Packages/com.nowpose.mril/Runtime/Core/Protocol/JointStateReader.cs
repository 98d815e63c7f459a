using System;
using System.Collections.Generic;

namespace Nowpose.Protocol
{
    /// <summary>Reads sensor_msgs/JointState. Allocates nothing if a source repeats its names and messages are released.</summary>
    sealed class JointStateReader
    {
        static readonly JsonNames Fields = new JsonNames("header", "name", "position", "velocity", "acceleration");

        readonly JointNamesReader _names = new JointNamesReader();
        readonly MessagePool<JointStateMessage> _pool = new MessagePool<JointStateMessage>();
        readonly List<double> _positions = new List<double>();
        readonly List<double> _velocities = new List<double>();
        readonly List<double> _accelerations = new List<double>();

        /// <param name="isNamed">Whether the header contains the name of the headset.</param>
        /// <returns>Null if the message is rejected.</returns>
        public JointStateMessage Read(ref JsonUtf8Reader json, bool isNamed)
        {
            var stamp = default(ControlTime);
            var frame = "";
            var names = Array.Empty<string>();
            var seen = 0;
            _positions.Clear();
            _velocities.Clear();
            _accelerations.Clear();
            if (!json.BeginObject()) return null;
            while (json.NextField(Fields, ref seen, out var field))
            {
                switch (field)
                {
                    case 0 when isNamed: RosTime.ReadNamedHeader(ref json, out stamp, out frame); break;
                    case 0: RosTime.ReadHeader(ref json, out stamp); break;
                    case 1: _names.Read(ref json, out names); break;
                    case 2: json.Numbers(_positions, areOptional: false); break;
                    case 3: ReadRates(ref json, _velocities); break;
                    default: ReadAccelerations(ref json); break;
                }
            }

            if (!json.EndObject(seen, 0b111) || !IsWhole(ref json, names.Length)) return null;
            var message = TakeMessage(names.Length);
            message.Fill(stamp, names, _positions, _velocities, _accelerations, frame);
            return message;
        }

        /// <summary>Reads velocities or accelerations: JSON null if there are none, null or NaN for a missing value.</summary>
        public static bool ReadRates(ref JsonUtf8Reader json, List<double> into) => json.TakeNull() || json.Numbers(into, areOptional: true);

        /// <summary>Returns whether the numbers of velocities and accelerations are each zero or equal to the number of joints.</summary>
        public static bool HaveLength(int joints, List<double> velocities, List<double> accelerations) =>
            (velocities.Count == 0 || velocities.Count == joints) && (accelerations.Count == 0 || accelerations.Count == joints);

        // With several alternating sources, a message with the right number of joints is near the front.
        JointStateMessage TakeMessage(int joints)
        {
            for (var left = _pool.Count; left > 0 && _pool.TryTake(out var message); left--)
            {
                if (message.Positions.Length == joints) return message;
                message.Release();
            }
            return new JointStateMessage(joints, _pool);
        }

        // The field is not part of sensor_msgs, so an invalid value is treated as absent instead of making the message invalid.
        void ReadAccelerations(ref JsonUtf8Reader json)
        {
            var ahead = json;
            if (ReadRates(ref ahead, _accelerations))
            {
                json = ahead;
                return;
            }
            _accelerations.Clear();
            json.Skip();
        }

        bool IsWhole(ref JsonUtf8Reader json, int joints)
        {
            if (_accelerations.Count != joints) _accelerations.Clear();
            if (_positions.Count != joints || !HaveLength(joints, _velocities, _accelerations)) return json.Fail(DropReason.LengthMismatch);
            return joints > 0 || json.Fail(DropReason.MissingField);
        }
    }
}
