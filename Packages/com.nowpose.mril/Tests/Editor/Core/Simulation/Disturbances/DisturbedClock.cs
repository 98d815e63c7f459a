using System;
using System.Collections.Generic;
using Nowpose.Simulation;

namespace Nowpose.Tests.Core.Simulation.Disturbances
{
    /// <summary>The control clock of a disturbed cell, which may step and change its rate. Times are seconds since the start of the run.</summary>
    sealed class DisturbedClock
    {
        const double MaxPostponed = 1;

        readonly HeadsetTime _start;
        readonly VirtualClock _clock;
        readonly List<Disturbance> _left;
        double _ahead = 1000, _skew = 37e-6, _stepped = double.NegativeInfinity;

        public DisturbedClock(HeadsetTime start, IEnumerable<Disturbance> disturbances)
        {
            _start = start;
            _clock = new VirtualClock(start, Lengths.Seconds(_ahead), _skew);
            _left = new List<Disturbance>(disturbances);
        }

        public HeadsetTime HeadsetAt(double time) => _start + Lengths.Seconds(time);

        public ControlTime ControlAt(double time) => _clock.At(HeadsetAt(time));

        public bool HasSteppedWithin(double seconds, double now) => now - _stepped < seconds;

        /// <summary>Moves the time from which on <see cref="HasSteppedWithin"/> counts to now, because nothing shows a step yet.</summary>
        public void Postpone(double now)
        {
            if (HasSteppedWithin(MaxPostponed, now)) _stepped = now;
        }

        /// <summary>Steps the clock, and changes its rate, as far as it is due.</summary>
        public void Run(double now)
        {
            foreach (var one in _left.FindAll(one => one.Start <= now))
            {
                if (one.Is(DisturbanceKind.ClockStep)) (_ahead, _stepped) = (_ahead + one.Size, now);
                if (one.Is(DisturbanceKind.ClockRate)) _skew += one.Size;
                _clock.Set(HeadsetAt(now), Lengths.Seconds(_ahead), _skew);
                _left.Remove(one);
            }
        }
    }
}
