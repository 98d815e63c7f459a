using System;

namespace Nowpose
{
    /// <summary>Headset time minus control time at the same moment, Φ of Eq. (3); positive when the headset clock is ahead.</summary>
    /// <remarks>
    /// Schnierle &amp; Röck 2022, Eq. (3). Valid at one moment only: because of the skew, Φ changes by γ₂−1 seconds per second, see
    /// <see cref="ClockModel"/>.
    /// </remarks>
    public readonly struct ClockOffset : IEquatable<ClockOffset>
    {
        readonly TimeSpan _headsetMinusControl;

        public ClockOffset(TimeSpan headsetMinusControl) => _headsetMinusControl = headsetMinusControl;

        public TimeSpan HeadsetMinusControl => _headsetMinusControl;

        public ControlTime ToControl(HeadsetTime t) => new ControlTime(t.SinceEpoch - _headsetMinusControl);
        public HeadsetTime ToHeadset(ControlTime t) => new HeadsetTime(t.SinceEpoch + _headsetMinusControl);

        public static TimeSpan operator -(ClockOffset a, ClockOffset b) => a._headsetMinusControl - b._headsetMinusControl;
        public static ClockOffset operator +(ClockOffset a, TimeSpan change) => new ClockOffset(a._headsetMinusControl + change);
        public static bool operator ==(ClockOffset a, ClockOffset b) => a._headsetMinusControl == b._headsetMinusControl;
        public static bool operator !=(ClockOffset a, ClockOffset b) => !(a == b);

        public bool Equals(ClockOffset other) => this == other;
        public override bool Equals(object obj) => obj is ClockOffset other && Equals(other);
        public override int GetHashCode() => _headsetMinusControl.GetHashCode();
        public override string ToString() => _headsetMinusControl + " (C2 - C1)";
    }
}
