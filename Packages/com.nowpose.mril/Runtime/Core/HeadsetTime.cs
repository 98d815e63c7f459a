using System;
using System.Globalization;

namespace Nowpose
{
    /// <summary>A point in time on the headset clock C2, the monotonic clock of the headset.</summary>
    /// <remarks>
    /// Stored in ticks of 100 ns since the headset clock's own epoch (often its start): only differences and the
    /// clock model have a meaning. <c>default</c> is the epoch itself. Cannot be mixed with
    /// <see cref="ControlTime"/>; only the clock model converts.
    /// </remarks>
    public readonly struct HeadsetTime : IEquatable<HeadsetTime>, IComparable<HeadsetTime>
    {
        readonly long _ticks;

        public HeadsetTime(TimeSpan sinceEpoch) => _ticks = sinceEpoch.Ticks;

        /// <summary>Time since the headset clock's epoch.</summary>
        public TimeSpan SinceEpoch => new TimeSpan(_ticks);

        /// <summary>Nanoseconds since the epoch, as on the wire.</summary>
        public long Nanoseconds => checked(_ticks * ClockTicks.NanosecondsPerTick);

        /// <param name="nanoseconds">Nanoseconds since the epoch; rounded to the nearest 100 ns.</param>
        public static HeadsetTime FromNanoseconds(long nanoseconds) =>
            new HeadsetTime(new TimeSpan(ClockTicks.FromNanoseconds(nanoseconds)));

        /// <param name="seconds">Seconds since the epoch; rounded to the nearest 100 ns.</param>
        public static HeadsetTime FromSeconds(double seconds) => new HeadsetTime(ClockTicks.Span(seconds));

        public static HeadsetTime operator +(HeadsetTime t, TimeSpan length) => new HeadsetTime(t.SinceEpoch + length);
        public static HeadsetTime operator -(HeadsetTime t, TimeSpan length) => new HeadsetTime(t.SinceEpoch - length);
        public static TimeSpan operator -(HeadsetTime end, HeadsetTime start) => end.SinceEpoch - start.SinceEpoch;
        public static bool operator ==(HeadsetTime a, HeadsetTime b) => a._ticks == b._ticks;
        public static bool operator !=(HeadsetTime a, HeadsetTime b) => a._ticks != b._ticks;
        public static bool operator <(HeadsetTime a, HeadsetTime b) => a._ticks < b._ticks;
        public static bool operator >(HeadsetTime a, HeadsetTime b) => a._ticks > b._ticks;
        public static bool operator <=(HeadsetTime a, HeadsetTime b) => a._ticks <= b._ticks;
        public static bool operator >=(HeadsetTime a, HeadsetTime b) => a._ticks >= b._ticks;

        public int CompareTo(HeadsetTime other) => _ticks.CompareTo(other._ticks);
        public bool Equals(HeadsetTime other) => _ticks == other._ticks;
        public override bool Equals(object obj) => obj is HeadsetTime other && Equals(other);
        public override int GetHashCode() => _ticks.GetHashCode();
        public override string ToString() =>
            SinceEpoch.TotalSeconds.ToString("0.0000000", CultureInfo.InvariantCulture) + " s on C2";
    }
}
