using System.Collections.Generic;

namespace Nowpose.Protocol
{
    /// <summary>Reads diagnostic_msgs/DiagnosticArray with exactly one status.</summary>
    static class DiagnosticsReader
    {
        static readonly string[] ArrayFields = { "status", "header" };
        static readonly string[] StatusFields = { "hardware_id", "values" };
        static readonly string[] PairFields = { "key", "value" };

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
            var hardware = default(string);
            var values = new List<KeyValuePair<string, string>>();
            var count = 0;
            var isRead = cursor.Object(ArrayFields, 1, field => field == 0
                ? cursor.Elements(() => (++count == 1 || cursor.Fail(DropReason.LengthMismatch)) && ReadStatus(cursor, out hardware, values))
                : RosTime.ReadOptionalHeader(cursor, out stamp));
            if (!isRead || count == 0)
                return isRead && cursor.Fail(DropReason.LengthMismatch);
            message = new DiagnosticsMessage(stamp, hardware, values);
            return true;
        }

        static bool ReadStatus(JsonCursor cursor, out string hardware, List<KeyValuePair<string, string>> values)
        {
            var name = default(string);
            var isRead = cursor.Object(StatusFields, 0b11, field => field == 0
                ? cursor.Name(out name)
                : cursor.Elements(() => ReadPair(cursor, values)));
            hardware = name;
            return isRead;
        }

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
