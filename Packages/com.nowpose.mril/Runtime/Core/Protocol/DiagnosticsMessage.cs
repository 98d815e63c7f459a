using System.Collections.Generic;

namespace Nowpose.Protocol
{
    /// <summary>diagnostic_msgs/DiagnosticArray with the one status of one headset.</summary>
    public sealed class DiagnosticsMessage
    {
        public DiagnosticsMessage(ControlTime stamp, string hardwareId, IReadOnlyList<KeyValuePair<string, string>> values)
        {
            Stamp = stamp;
            HardwareId = hardwareId;
            Values = values;
        }

        /// <summary>When it was written; the epoch (zero) while the headset is unsynchronised. Never used as t_k.</summary>
        public ControlTime Stamp { get; }

        /// <summary>The headset's name.</summary>
        public string HardwareId { get; }

        /// <summary>Keys with their values as text, units in the key (offset_ns, rtt_ms).</summary>
        public IReadOnlyList<KeyValuePair<string, string>> Values { get; }
    }
}
