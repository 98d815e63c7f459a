using System;

namespace Nowpose.Protocol
{
    /// <summary>Reads the response from a service whose name begins with <see cref="RosTopics.PlantTime"/>.</summary>
    static class PlantTimeReader
    {
        /// <summary>Maximum resolution and error bound in ns. A clock with larger values is not accurate enough to stamp positions.</summary>
        const long MaxResolution = 1_000_000_000, MaxErrorBound = 60_000_000_000;

        static readonly JsonNames Fields = new JsonNames("received", "sent", "resolution_ns", "error_bound_ns", "synchronised");

        public static bool Read(ref JsonUtf8Reader json, RosbridgeMessage into)
        {
            ControlTime received = default, sent = default;
            TimeSpan resolution = default, bound = default;
            var isSynchronised = true;
            var seen = 0;
            if (!json.BeginObject()) return false;
            while (json.NextField(Fields, ref seen, out var field))
            {
                switch (field)
                {
                    case 0: RosTime.ReadStamp(ref json, out received); break;
                    case 1: RosTime.ReadStamp(ref json, out sent); break;
                    case 2: ReadLength(ref json, MaxResolution, out resolution); break;
                    case 3: ReadLength(ref json, MaxErrorBound, out bound); break;
                    default: json.Flag(out isSynchronised); break;
                }
            }

            if (!json.EndObject(seen, 0b11)) return false;
            into.PlantTime = new PlantTimeMessage(received, sent, resolution, bound, isSynchronised);
            return true;
        }

        static bool ReadLength(ref JsonUtf8Reader json, long maxNanoseconds, out TimeSpan length)
        {
            length = default;
            if (!json.Integer(out var nanoseconds)) return false;
            if (nanoseconds < 0 || nanoseconds > maxNanoseconds) return json.Fail(DropReason.OutOfRange);
            length = new TimeSpan(nanoseconds / ClockTicks.NanosecondsPerTick);
            return true;
        }
    }
}
