using System;
using Nowpose.Counter;

namespace Nowpose.Tests.Core
{
    /// <summary>Two counters driven by one oscillator, in virtual time. Each reading takes some time.</summary>
    sealed class PlayedCounters
    {
        readonly Random _random = new Random(16);
        decimal _seconds;

        /// <param name="upTimeSeconds">Time since the counter was zero.</param>
        public PlayedCounters(long frequency, decimal upTimeSeconds, decimal stopwatchLagSeconds)
        {
            _seconds = upTimeSeconds;
            Counter = new Played(this, frequency, 0);
            Stopwatch = new Played(this, 10_000_000, stopwatchLagSeconds);
        }

        public ICounter Counter { get; }
        public ICounter Stopwatch { get; }

        /// <summary>Function that returns the duration in s of the pause after the reading with the given index; 0 for no pause.</summary>
        public Func<int, double> PauseAfter { get; set; } = _ => 0;

        public int Readings { get; private set; }

        long Read(long frequency, decimal lag)
        {
            // A reading takes 50 to 150 ns.
            _seconds += (decimal)(50e-9 + 100e-9 * _random.NextDouble());
            var count = decimal.ToInt64(decimal.Floor((_seconds - lag) * frequency));
            _seconds += (decimal)PauseAfter(Readings++);
            return count;
        }

        sealed class Played : ICounter
        {
            readonly PlayedCounters _device;
            readonly decimal _lag;

            public Played(PlayedCounters device, long frequency, decimal lag)
            {
                _device = device;
                _lag = lag;
                Frequency = frequency;
            }

            public long Frequency { get; }

            public long Read() => _device.Read(Frequency, _lag);
        }
    }
}
