using System;

namespace Nowpose.Protocol
{
    /// <summary>Reads the answer of a service below <see cref="RosTopics.PlantTime"/>.</summary>
    static class PlantTimeReader
    {
        /// <summary>Beyond these it is no clock that positions could be stamped by.</summary>
        const long GreatestResolution = 1_000_000_000, GreatestErrorBound = 60_000_000_000;

        static readonly string[] Fields = { "received", "sent", "resolution_ns", "error_bound_ns", "synchronised" };

        public static bool Read(JsonCursor cursor, RosbridgeMessage into)
        {
            ControlTime received = default, sent = default;
            TimeSpan resolution = default, bound = default;
            var isSynchronised = true;
            var isRead = cursor.Object(Fields, 0b11, field => field switch
            {
                0 => RosTime.ReadStamp(cursor, out received),
                1 => RosTime.ReadStamp(cursor, out sent),
                2 => ReadLength(cursor, GreatestResolution, out resolution),
                3 => ReadLength(cursor, GreatestErrorBound, out bound),
                _ => cursor.Flag(out isSynchronised),
            });
            if (isRead) into.PlantTime = new PlantTimeMessage(received, sent, resolution, bound, isSynchronised);
            return isRead;
        }

        static bool ReadLength(JsonCursor cursor, long greatestNanoseconds, out TimeSpan length)
        {
            length = default;
            if (!cursor.Integer(out var nanoseconds)) return false;
            if (nanoseconds < 0 || nanoseconds > greatestNanoseconds) return cursor.Fail(DropReason.OutOfRange);
            length = new TimeSpan(nanoseconds / ClockTicks.NanosecondsPerTick);
            return true;
        }
    }
}
