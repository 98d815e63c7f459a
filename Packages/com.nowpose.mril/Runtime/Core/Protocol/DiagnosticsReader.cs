using System;
using System.Collections.Generic;

namespace Nowpose.Protocol
{
    /// <summary>Reads diagnostic_msgs/DiagnosticArray with exactly one status.</summary>
    static class DiagnosticsReader
    {
        static readonly string[] ArrayFields = { "status", "header" };
        static readonly string[] StatusFields = { "hardware_id", "values", "level", "name", "message" };
        static readonly string[] PairFields = { "key", "value" };
        const int MaxLevel = 3;

        public static bool Read(JsonCursor cursor, RosbridgeMessage into)
        {
            var isRead = TryRead(cursor, out var message);
            into.Diagnostics = message;
            return isRead;
        }

        public static bool TryRead(JsonCursor cursor, out DiagnosticsMessage message)
        {
            message = null;
            var stamp = default(ControlTime);
            var status = default(Status);
            var count = 0;
            var isRead = cursor.Object(ArrayFields, 1, field => field == 0
                ? cursor.Elements(() => (++count == 1 || cursor.Fail(DropReason.LengthMismatch)) && ReadStatus(cursor, out status))
                : RosTime.ReadOptionalHeader(cursor, out stamp));
            if (!isRead || count == 0)
                return isRead && cursor.Fail(DropReason.LengthMismatch);
            message = new DiagnosticsMessage(stamp, status.HardwareId, status.Values, status.Level, status.Name, status.Message);
            return true;
        }

        sealed class Status
        {
            public string HardwareId, Name = "", Message = "";
            public int Level;
            public readonly List<KeyValuePair<string, string>> Values = new List<KeyValuePair<string, string>>();
        }

        static bool ReadStatus(JsonCursor cursor, out Status status)
        {
            var read = status = new Status();
            return cursor.Object(StatusFields, 0b11, field =>
            {
                switch (field)
                {
                    case 0: return cursor.Name(out read.HardwareId);
                    case 1: return cursor.Elements(() => ReadPair(cursor, read.Values));
                    case 2: return ReadLevel(cursor, out read.Level);
                    case 3: return ReadText(cursor, ref read.Name);
                    default: return ReadText(cursor, ref read.Message);
                }
            });
        }

        // ROS writes a byte as a number or as a text, depending on its version.
        static bool ReadLevel(JsonCursor cursor, out int level)
        {
            level = 0;
            if (!cursor.IsInteger) return cursor.Skip();
            var isRead = cursor.Integer(out var value);
            level = (int)Math.Min(Math.Max(value, 0), MaxLevel);
            return isRead;
        }

        static bool ReadText(JsonCursor cursor, ref string text) => cursor.IsText ? cursor.Text(out text) : cursor.Skip();

        static bool ReadPair(JsonCursor cursor, List<KeyValuePair<string, string>> into)
        {
            var key = default(string);
            var value = default(string);
            var isRead = cursor.Object(PairFields, 0b11, field => field == 0 ? cursor.Name(out key) : cursor.Text(out value));
            into.Add(new KeyValuePair<string, string>(key, value));
            return isRead;
        }
    }
}
