using System;
using System.Collections.Generic;

namespace Nowpose.Protocol
{
    /// <summary>Reads diagnostic_msgs/DiagnosticArray with exactly one status.</summary>
    static class DiagnosticsReader
    {
        static readonly JsonNames ArrayFields = new JsonNames("status", "header");
        static readonly JsonNames StatusFields = new JsonNames("hardware_id", "values", "level", "name", "message");
        static readonly JsonNames PairFields = new JsonNames("key", "value");
        const int MaxLevel = 3;

        public static bool Read(ref JsonUtf8Reader json, RosbridgeMessage into)
        {
            var isRead = TryRead(ref json, areKeysNames: false, out var message);
            into.Diagnostics = message;
            return isRead;
        }

        /// <param name="areKeysNames">Whether each key is only a name, which may have the namespace of a robot before it.</param>
        public static bool TryRead(ref JsonUtf8Reader json, bool areKeysNames, out DiagnosticsMessage message)
        {
            message = null;
            var stamp = default(ControlTime);
            var status = default(Status);
            var seen = 0;
            if (!json.BeginObject()) return false;
            while (json.NextField(ArrayFields, ref seen, out var field))
                if (field == 0) ReadOnlyStatus(ref json, areKeysNames, out status);
                else RosTime.ReadOptionalHeader(ref json, out stamp);
            if (!json.EndObject(seen, 1)) return false;
            message = new DiagnosticsMessage(stamp, status.HardwareId, status.Values, status.Level, status.Name, status.Message);
            return true;
        }

        sealed class Status
        {
            public string HardwareId, Name = "", Message = "";
            public int Level;
            public bool AreKeysNames;
            public readonly List<KeyValuePair<string, string>> Values = new List<KeyValuePair<string, string>>();
        }

        static bool ReadOnlyStatus(ref JsonUtf8Reader json, bool areKeysNames, out Status status)
        {
            status = null;
            if (!json.BeginArray()) return false;
            while (json.NextElement())
            {
                if (status != null) return json.Fail(DropReason.LengthMismatch);
                ReadStatus(ref json, status = new Status { AreKeysNames = areKeysNames });
            }

            return json.Fault == DropReason.None && (status != null || json.Fail(DropReason.LengthMismatch));
        }

        static bool ReadStatus(ref JsonUtf8Reader json, Status into)
        {
            var seen = 0;
            if (!json.BeginObject()) return false;
            while (json.NextField(StatusFields, ref seen, out var field))
            {
                switch (field)
                {
                    case 0: json.Name(out into.HardwareId); break;
                    case 1: ReadPairs(ref json, into); break;
                    case 2: ReadLevel(ref json, out into.Level); break;
                    case 3: ReadText(ref json, ref into.Name); break;
                    default: ReadText(ref json, ref into.Message); break;
                }
            }

            return json.EndObject(seen, 0b11);
        }

        // ROS encodes a byte as a number or as a string, depending on the ROS version.
        static bool ReadLevel(ref JsonUtf8Reader json, out int level)
        {
            level = 0;
            if (!json.IsInteger) return json.Skip();
            var isRead = json.Integer(out var value);
            level = (int)Math.Min(Math.Max(value, 0), MaxLevel);
            return isRead;
        }

        static bool ReadText(ref JsonUtf8Reader json, ref string text) => json.IsText ? json.Text(out text) : json.Skip();

        static bool ReadPairs(ref JsonUtf8Reader json, Status into)
        {
            if (!json.BeginArray()) return false;
            while (json.NextElement() && ReadPair(ref json, into.AreKeysNames, out var pair)) into.Values.Add(pair);
            return json.Fault == DropReason.None;
        }

        static bool ReadPair(ref JsonUtf8Reader json, bool isKeyName, out KeyValuePair<string, string> pair)
        {
            pair = default;
            string key = null, value = null;
            var seen = 0;
            if (!json.BeginObject()) return false;
            while (json.NextField(PairFields, ref seen, out var field))
                if (field == 1) json.Text(out value);
                else if (isKeyName) json.QualifiedName(out key);
                else json.Key(out key);
            pair = new KeyValuePair<string, string>(key, value);
            return json.EndObject(seen, 0b11);
        }
    }
}
