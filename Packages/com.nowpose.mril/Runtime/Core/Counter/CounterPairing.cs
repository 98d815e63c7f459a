using System;
using System.Globalization;
using Nowpose.Messages;

namespace Nowpose.Counter
{
    /// <summary>Converts counts of one counter to counts of another counter that runs on the same oscillator.</summary>
    /// <remarks>
    /// On Windows, <see cref="System.Diagnostics.Stopwatch"/> is the performance counter, scaled and possibly shifted by a constant. The
    /// offset between the two therefore never changes, even during sleep, and one measurement is valid as long as the process runs.
    /// </remarks>
    sealed class CounterPairing
    {
        /// <summary>
        /// Number of measurements (brackets). In each, the target is read between two readings of the counter. An interrupt may disturb a few of
        /// them, but never all.
        /// </summary>
        internal const int Brackets = 32;

        readonly long _frequency, _targetFrequency, _count, _reading;

        CounterPairing(long frequency, long targetFrequency, long before, long reading, long after)
        {
            _frequency = frequency;
            _targetFrequency = targetFrequency;
            _count = before + (after - before) / 2;
            _reading = reading;
            Uncertainty = ClockTicks.Span(0.5 * (after - before) / frequency + 1.0 / frequency + 1.0 / targetFrequency);
        }

        /// <summary>Counts per second of the counter whose counts are converted.</summary>
        public long Frequency => _frequency;

        /// <summary>Upper bound of the offset's error: half the duration of the shortest bracket, plus one count of each counter.</summary>
        public TimeSpan Uncertainty { get; }

        /// <summary>Measures both counters several times and keeps the measurement with the shortest duration.</summary>
        /// <param name="open">Returns the counter whose counts are to be converted; throws if the platform has none.</param>
        /// <param name="target">The counter to convert to.</param>
        /// <param name="fault">Reason for the failure, in one line; null on success.</param>
        public static bool TryMeasure(Func<ICounter> open, ICounter target, out CounterPairing pairing, out string fault)
        {
            pairing = null;
            ICounter counter;
            try
            {
                counter = open();
            }
            // A missing library and a missing entry point both derive from this exception.
            catch (TypeLoadException missing)
            {
                fault = CounterMessages.Missing(missing.Message);
                return false;
            }
            fault = FaultOf(counter.Frequency, target.Frequency);
            if (fault != null) return false;
            pairing = Shortest(counter, target);
            fault = pairing == null ? CounterMessages.WentBack(Brackets) : null;
            return pairing != null;
        }

        /// <summary>
        /// Converts a count to a count of the target. The result is rounded towards the time of the pairing, so its error is below one count.
        /// Allocates nothing.
        /// </summary>
        /// <param name="count">Count to convert. For a count that no device can reach, the result is undefined, but no exception is thrown.</param>
        public long ToTarget(long count)
        {
            // Converts whole seconds separately: the product of a large count and the other frequency would overflow.
            var since = count - _count;
            return _reading + since / _frequency * _targetFrequency + since % _frequency * _targetFrequency / _frequency;
        }

        static string FaultOf(long frequency, long targetFrequency)
        {
            if (frequency <= 0) return CounterMessages.NotWorking(Hz(frequency));
            return frequency > long.MaxValue / targetFrequency ? CounterMessages.FrequencyImplausible(Hz(frequency)) : null;
        }

        static CounterPairing Shortest(ICounter counter, ICounter target)
        {
            CounterPairing best = null;
            for (var (i, shortest) = (0, long.MaxValue); i < Brackets; i++)
            {
                var before = counter.Read();
                var reading = target.Read();
                var after = counter.Read();
                var length = after - before;
                if (length < 0 || length >= shortest) continue;
                shortest = length;
                best = new CounterPairing(counter.Frequency, target.Frequency, before, reading, after);
            }
            return best;
        }

        static string Hz(long frequency) => frequency.ToString(CultureInfo.InvariantCulture) + " Hz";
    }
}
