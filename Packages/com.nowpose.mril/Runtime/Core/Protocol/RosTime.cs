using System;

namespace Nowpose.Protocol
{
    /// <summary>Reads times and lengths of time in both spellings of ROS.</summary>
    static class RosTime
    {
        const long NanosecondsPerSecond = 1_000_000_000;

        static readonly string[] Header = { "stamp" };
        static readonly string[] NamedHeader = { "stamp", "frame_id" };
        static readonly string[] Parts = { "secs", "nsecs", "sec", "nanosec" };

        /// <summary>The stamp of a header, which must be one: zero means "none" to ROS.</summary>
        public static bool ReadHeader(JsonCursor cursor, out ControlTime stamp)
        {
            var read = default(ControlTime);
            var isRead = cursor.Object(Header, 1, _ => ReadStamp(cursor, out read));
            stamp = read;
            return isRead;
        }

        /// <summary>The stamp of a header, and whose it is.</summary>
        public static bool ReadNamedHeader(JsonCursor cursor, out ControlTime stamp, out string frame)
        {
            var read = default(ControlTime);
            var name = default(string);
            var isRead = cursor.Object(NamedHeader, 0b11, field => field == 0 ? ReadStamp(cursor, out read) : cursor.Name(out name));
            stamp = read;
            frame = name;
            return isRead;
        }

        /// <summary>The stamp of a header, or the epoch where there is none.</summary>
        public static bool ReadOptionalHeader(JsonCursor cursor, out ControlTime stamp)
        {
            var read = default(ControlTime);
            var isRead = cursor.Object(Header, 0, _ => ReadPoint(cursor, out read));
            stamp = read;
            return isRead;
        }

        public static bool ReadStamp(JsonCursor cursor, out ControlTime stamp) =>
            ReadPoint(cursor, out stamp) && (stamp != default || cursor.Fail(DropReason.StampZero));

        public static bool ReadLength(JsonCursor cursor, out TimeSpan length)
        {
            var isRead = Read(cursor, int.MinValue, int.MaxValue, out var nanoseconds);
            length = ControlTime.FromNanoseconds(nanoseconds).SinceEpoch;
            return isRead;
        }

        static bool ReadPoint(JsonCursor cursor, out ControlTime point)
        {
            // ROS 1 counts seconds in an u32, ROS 2 in an i32: what either can say fits into 64 bits of nanoseconds.
            var isRead = Read(cursor, 0, uint.MaxValue, out var nanoseconds);
            point = ControlTime.FromNanoseconds(nanoseconds);
            return isRead;
        }

        static bool Read(JsonCursor cursor, long lowest, long highest, out long nanoseconds)
        {
            var values = new long?[Parts.Length];
            nanoseconds = 0;
            if (!cursor.Object(Parts, 0, part => ReadPart(cursor, out values[part])))
                return false;
            var isRos1 = values[0].HasValue || values[1].HasValue;
            if (isRos1 && (values[2].HasValue || values[3].HasValue))
                return cursor.Fail(DropReason.DuplicateField);
            return Combine(cursor, values[isRos1 ? 0 : 2], values[isRos1 ? 1 : 3], lowest, highest, out nanoseconds);
        }

        static bool ReadPart(JsonCursor cursor, out long? part)
        {
            var isRead = cursor.Integer(out var value);
            part = value;
            return isRead;
        }

        static bool Combine(JsonCursor cursor, long? seconds, long? rest, long lowest, long highest, out long nanoseconds)
        {
            nanoseconds = 0;
            if (!seconds.HasValue || !rest.HasValue)
                return cursor.Fail(DropReason.MissingField);
            if (seconds < lowest || seconds > highest || rest < 0 || rest >= NanosecondsPerSecond)
                return cursor.Fail(DropReason.StampOutOfRange);
            nanoseconds = seconds.Value * NanosecondsPerSecond + rest.Value;
            return true;
        }
    }
}
