using System;

namespace Nowpose.Simulation
{
    /// <summary>A simulated control clock with known offset and rate, which may be changed at run time.</summary>
    public sealed class VirtualClock
    {
        HeadsetTime _since;
        ControlTime _then;
        TimeSpan _ahead;
        double _skew;

        /// <param name="start">Headset time at which the clocks differ by exactly <paramref name="ahead"/>.</param>
        /// <param name="ahead">Control time minus headset time at the start: −Φ.</param>
        /// <param name="skew">Rate of the control clock relative to the headset clock, minus one. 1e-6 is 1 ppm.</param>
        public VirtualClock(HeadsetTime start, TimeSpan ahead, double skew)
        {
            _since = start;
            _then = new ControlTime(start.SinceEpoch + ahead);
            _ahead = ahead;
            _skew = skew;
        }

        /// <summary>Returns the control time at a headset time.</summary>
        public ControlTime At(HeadsetTime t)
        {
            var passed = t - _since;
            return _then + passed + new TimeSpan((long)Math.Round(passed.Ticks * _skew));
        }

        /// <summary>Changes the rate from now on, and steps the clock by the change of <paramref name="ahead"/>.</summary>
        public void Set(HeadsetTime now, TimeSpan ahead, double skew)
        {
            if (ahead == _ahead && skew == _skew) return;
            _then = At(now) + (ahead - _ahead);
            _since = now;
            _ahead = ahead;
            _skew = skew;
        }
    }
}
