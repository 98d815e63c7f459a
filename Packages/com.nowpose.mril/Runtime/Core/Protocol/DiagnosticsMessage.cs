using System.Collections.Generic;
using Newtonsoft.Json;

namespace Nowpose.Protocol
{
    /// <summary>diagnostic_msgs/DiagnosticArray with one status, which describes a headset, an adapter, or the joints.</summary>
    sealed class DiagnosticsMessage : IRosMessage
    {
        /// <param name="level">Level of the status: 0 ok, 1 warning, 2 error, 3 stale.</param>
        public DiagnosticsMessage(
            ControlTime stamp, string hardwareId, IReadOnlyList<KeyValuePair<string, string>> values, int level = 0, string name = "nowpose",
            string message = "")
        {
            Stamp = stamp;
            HardwareId = hardwareId;
            Values = values;
            Level = level;
            Name = name;
            Message = message;
        }

        /// <summary>Time of writing; the epoch (zero) while the headset is unsynchronised. It is never used as t_k.</summary>
        public ControlTime Stamp { get; }

        /// <summary>Level of the status, as in DiagnosticStatus: 0 ok, 1 warning, 2 error, 3 stale.</summary>
        public int Level { get; }

        /// <summary>Name of the status. May be empty.</summary>
        public string Name { get; }

        /// <summary>The status in one line; may be empty.</summary>
        public string Message { get; }

        /// <summary>Name of the headset or adapter.</summary>
        public string HardwareId { get; }

        /// <summary>Keys with their values as text; units are in the key (offset_ns, rtt_ms).</summary>
        public IReadOnlyList<KeyValuePair<string, string>> Values { get; }

        public void Write(JsonWriter json, RosTimeForm form)
        {
            json.WriteStartObject();
            json.Header(Stamp, form);
            json.StartArray("status");
            json.WriteStartObject();
            json.WritePropertyName("level");
            json.WriteValue(Level);
            json.Text("name", Name);
            json.Text("message", Message);
            json.Text("hardware_id", HardwareId);
            json.StartArray("values");
            foreach (var pair in Values)
            {
                json.WriteStartObject();
                json.Text("key", pair.Key);
                json.Text("value", pair.Value);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteEndObject();
            json.WriteEndArray();
            json.WriteEndObject();
        }
    }
}
