using System;

namespace Nowpose.Protocol
{
    /// <summary>Notation of a ROS time in JSON.</summary>
    enum RosTimeForm
    {
        /// <summary>ROS 2: <c>sec</c> and <c>nanosec</c>; also used if a client specifies no type.</summary>
        Sec,

        /// <summary>ROS 1: <c>secs</c> and <c>nsecs</c>.</summary>
        Secs,
    }

    /// <summary>Reads times and durations in the notations of ROS 1 and ROS 2.</summary>
    static class RosTime
    {
        const long NanosecondsPerSecond = 1_000_000_000;

        static readonly JsonNames Header = new JsonNames("stamp");
        static readonly JsonNames NamedHeader = new JsonNames("stamp", "frame_id");
        static readonly JsonNames Parts = new JsonNames("secs", "nsecs", "sec", "nanosec");

        /// <summary>Reads the stamp of a header, which is required; rejects zero, because it means "no time" in ROS.</summary>
        public static bool ReadHeader(ref JsonUtf8Reader json, out ControlTime stamp) =>
            ReadHeader(ref json, Header, 0b1, false, null, out stamp, out _);

        /// <summary>Reads the stamp of a header. If the header has no stamp, the result is the epoch.</summary>
        public static bool ReadOptionalHeader(ref JsonUtf8Reader json, out ControlTime stamp) =>
            ReadHeader(ref json, Header, 0, true, null, out stamp, out _);

        /// <summary>Reads the stamp of a header and its frame_id, which names the headset.</summary>
        public static bool ReadNamedHeader(ref JsonUtf8Reader json, out ControlTime stamp, out string frame) =>
            ReadHeader(ref json, NamedHeader, 0b11, false, null, out stamp, out frame);

        /// <summary>Reads the stamp of a header and its frame_id, which names a frame or a link of a robot.</summary>
        /// <param name="isZeroAllowed">Whether the stamp may be zero.</param>
        public static bool ReadFrameHeader(
            ref JsonUtf8Reader json, JsonNameCache names, bool isZeroAllowed, out ControlTime stamp, out string frame) =>
            ReadHeader(ref json, NamedHeader, 0b11, isZeroAllowed, names, out stamp, out frame);

        // Reads frame_id as the name of a frame with the cache of such names; without a cache, as the name of a headset.
        static bool ReadHeader(
            ref JsonUtf8Reader json, JsonNames fields, int required, bool isZeroAllowed, JsonNameCache frames, out ControlTime stamp, out string frame)
        {
            stamp = default;
            frame = null;
            var seen = 0;
            if (!json.BeginObject()) return false;
            while (json.NextField(fields, ref seen, out var field))
                if (field == 1 && frames == null) json.Name(out frame);
                else if (field == 1) json.QualifiedName(frames, out frame);
                else if (isZeroAllowed) ReadPoint(ref json, out stamp);
                else ReadStamp(ref json, out stamp);
            return json.EndObject(seen, required);
        }

        public static bool ReadStamp(ref JsonUtf8Reader json, out ControlTime stamp) =>
            ReadPoint(ref json, out stamp) && (stamp != default || json.Fail(DropReason.StampZero));

        public static bool ReadLength(ref JsonUtf8Reader json, out TimeSpan length)
        {
            var isRead = Read(ref json, int.MinValue, int.MaxValue, out var nanoseconds);
            length = ControlTime.FromNanoseconds(nanoseconds).SinceEpoch;
            return isRead;
        }

        static bool ReadPoint(ref JsonUtf8Reader json, out ControlTime point)
        {
            // ROS 1 stores seconds as u32, ROS 2 as i32. Both ranges fit into 64 bits of nanoseconds.
            var isRead = Read(ref json, 0, uint.MaxValue, out var nanoseconds);
            point = ControlTime.FromNanoseconds(nanoseconds);
            return isRead;
        }

        static bool Read(ref JsonUtf8Reader json, long lowest, long highest, out long nanoseconds)
        {
            nanoseconds = 0;
            Span<long> values = stackalloc long[4];
            var seen = 0;
            if (!json.BeginObject()) return false;
            while (json.NextField(Parts, ref seen, out var part)) json.Integer(out values[part]);
            if (!json.EndObject(seen, 0)) return false;
            var isRos1 = (seen & 0b11) != 0;
            if (isRos1 && seen > 0b11) return json.Fail(DropReason.DuplicateField);
            if (seen != (isRos1 ? 0b11 : 0b1100)) return json.Fail(DropReason.MissingField);
            var (seconds, rest) = (values[isRos1 ? 0 : 2], values[isRos1 ? 1 : 3]);
            if (seconds < lowest || seconds > highest || rest < 0 || rest >= NanosecondsPerSecond)
                return json.Fail(DropReason.StampOutOfRange);
            nanoseconds = seconds * NanosecondsPerSecond + rest;
            return true;
        }
    }
}
