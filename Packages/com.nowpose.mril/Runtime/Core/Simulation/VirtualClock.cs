using System;

namespace Nowpose.Simulation
{
    /// <summary>A control clock whose truth is known: it may be stepped and run at another rate while it is in use.</summary>
    public sealed class VirtualClock
    {
        HeadsetTime _since;
        ControlTime _then;
        TimeSpan _ahead;
        double _skew;

        /// <param name="start">Headset time at which both clocks show the same, but for <paramref name="ahead"/>.</param>
        /// <param name="ahead">What the control clock is ahead of the headset's then: −Φ.</param>
        /// <param name="skew">Its rate less one, as seen from the headset: it gains so many seconds in a second. 1e-6 is 1 ppm.</param>
        public VirtualClock(HeadsetTime start, TimeSpan ahead, double skew)
        {
            _since = start;
            _then = new ControlTime(start.SinceEpoch + ahead);
            _ahead = ahead;
            _skew = skew;
        }

        /// <summary>What the clock shows at a moment.</summary>
        public ControlTime At(HeadsetTime t)
        {
            var passed = t - _since;
            return _then + passed + new TimeSpan((long)Math.Round(passed.Ticks * _skew));
        }

        /// <summary>From now on it runs at another rate, and if it shall be ahead by another time than before, it steps by the difference.</summary>
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
