using System;
using System.Globalization;

namespace Nowpose
{
    /// <summary>A point in time on the control clock C1, the master clock of the control system.</summary>
    /// <remarks>
    /// Stored in ticks of 100 ns since the control clock's own epoch, which is arbitrary: only differences and the
    /// clock model have a meaning. <c>default</c> is the epoch itself. Cannot be mixed with
    /// <see cref="HeadsetTime"/>; only the clock model converts.
    /// </remarks>
    public readonly struct ControlTime : IEquatable<ControlTime>, IComparable<ControlTime>
    {
        readonly long _ticks;

        public ControlTime(TimeSpan sinceEpoch) => _ticks = sinceEpoch.Ticks;

        /// <summary>Time since the control clock's epoch.</summary>
        public TimeSpan SinceEpoch => new TimeSpan(_ticks);

        /// <summary>Nanoseconds since the epoch, as on the wire.</summary>
        public long Nanoseconds => checked(_ticks * ClockTicks.NanosecondsPerTick);

        /// <param name="nanoseconds">Nanoseconds since the epoch; rounded to the nearest 100 ns.</param>
        public static ControlTime FromNanoseconds(long nanoseconds) =>
            new ControlTime(new TimeSpan(ClockTicks.FromNanoseconds(nanoseconds)));

        /// <param name="seconds">Seconds since the epoch; rounded to the nearest 100 ns.</param>
        public static ControlTime FromSeconds(double seconds) => new ControlTime(ClockTicks.Span(seconds));

        public static ControlTime operator +(ControlTime t, TimeSpan length) => new ControlTime(t.SinceEpoch + length);
        public static ControlTime operator -(ControlTime t, TimeSpan length) => new ControlTime(t.SinceEpoch - length);
        public static TimeSpan operator -(ControlTime end, ControlTime start) => end.SinceEpoch - start.SinceEpoch;
        public static bool operator ==(ControlTime a, ControlTime b) => a._ticks == b._ticks;
        public static bool operator !=(ControlTime a, ControlTime b) => a._ticks != b._ticks;
        public static bool operator <(ControlTime a, ControlTime b) => a._ticks < b._ticks;
        public static bool operator >(ControlTime a, ControlTime b) => a._ticks > b._ticks;
        public static bool operator <=(ControlTime a, ControlTime b) => a._ticks <= b._ticks;
        public static bool operator >=(ControlTime a, ControlTime b) => a._ticks >= b._ticks;

        public int CompareTo(ControlTime other) => _ticks.CompareTo(other._ticks);
        public bool Equals(ControlTime other) => _ticks == other._ticks;
        public override bool Equals(object obj) => obj is ControlTime other && Equals(other);
        public override int GetHashCode() => _ticks.GetHashCode();
        public override string ToString() =>
            SinceEpoch.TotalSeconds.ToString("0.0000000", CultureInfo.InvariantCulture) + " s on C1";
    }
}
