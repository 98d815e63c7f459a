using System;
using System.Collections.Generic;
using System.Globalization;

namespace Nowpose.Protocol
{
    /// <summary>Reads the joint status of a gateway: diagnostic_msgs/DiagnosticArray with one value "STATE SINCE REASON" per joint.</summary>
    static class JointStatusReader
    {
        /// <summary>Maximum length of a reason in UTF-16 code units. A longer reason is truncated.</summary>
        const int MaxReasonLength = 256;

        /// <returns>Null if the message is rejected.</returns>
        public static JointStatusMessage Read(ref JsonUtf8Reader json)
        {
            if (!DiagnosticsReader.TryRead(ref json, areKeysNames: true, out var message)) return null;
            var joints = new List<JointReport>(message.Values.Count);
            var names = new HashSet<string>(StringComparer.Ordinal);
            foreach (var pair in message.Values)
            {
                if (joints.Count == ProtocolLimits.Joints) return Refused(ref json, DropReason.TooManyJoints);
                if (!names.Add(pair.Key)) return Refused(ref json, DropReason.DuplicateName);
                if (!TryRead(pair.Key, pair.Value, out var report)) return Refused(ref json, DropReason.OutOfRange);
                joints.Add(report);
            }
            return new JointStatusMessage(joints);
        }

        static JointStatusMessage Refused(ref JsonUtf8Reader json, DropReason reason)
        {
            json.Fail(reason);
            return null;
        }

        static bool TryRead(string joint, string value, out JointReport report)
        {
            report = default;
            var parts = value.Split(' ', 3);
            if (parts.Length < 2 || !JointDataStates.TryRead(parts[0], out var state) || !TryReadTime(parts[1], out var since)) return false;
            report = new JointReport(joint, state, since, parts.Length < 3 ? "" : InputException.OneLine(parts[2].Trim(), MaxReasonLength));
            return true;
        }

        static bool TryReadTime(string text, out ControlTime time)
        {
            time = default;
            const NumberStyles style = NumberStyles.AllowDecimalPoint | NumberStyles.AllowLeadingSign;
            if (!decimal.TryParse(text, style, CultureInfo.InvariantCulture, out var seconds) || Math.Abs(seconds) > uint.MaxValue)
                return false;
            // The time may be negative: a joint may have stopped before the epoch of a control clock that starts at zero.
            time = new ControlTime(new TimeSpan((long)(seconds * TimeSpan.TicksPerSecond)));
            return true;
        }
    }
}
