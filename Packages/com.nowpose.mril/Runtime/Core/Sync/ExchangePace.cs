using System;

namespace Nowpose.Sync
{
    /// <summary>
    /// Schedules the sync exchanges. The pace is quick initially, after a step or a long silence, and while a step is suspected. It is slow while
    /// the offset is so accurate that more exchanges would not improve it, if this is allowed. Otherwise the configured pace applies. Single-threaded.
    /// </summary>
    sealed class ExchangePace
    {
        /// <summary>Minimum interval between two exchanges; the resulting rate is half the rate that a server accepts.</summary>
        static readonly TimeSpan MinInterval = TimeSpan.FromMilliseconds(20);

        /// <summary>Maximum interval: a sixth of a server's idle timeout.</summary>
        static readonly TimeSpan MaxInterval = TimeSpan.FromSeconds(10);

        const int QuickFactor = 4, SlowFactor = 5;

        /// <summary>
        /// QuickAtStart: number of initial quick exchanges; they take five seconds if the configured interval is 200 ms. QuickAfterSilence:
        /// number of quick exchanges after a silence; they take about one second.
        /// </summary>
        const int QuickAtStart = 100, QuickAfterSilence = 25;

        /// <summary>
        /// Maximum number of quick exchanges before the clock is synchronised. They take 50 s if the configured interval is 200 ms.
        /// </summary>
        const int QuickUntilSynchronised = 1000;

        /// <summary>
        /// SlowBelow: standard error of the offset below which the slow pace starts. SlowUntil: standard error at which the slow pace ends. A wired
        /// network reaches this accuracy. WiFi rarely reaches it, so more exchanges still improve the offset.
        /// </summary>
        static readonly TimeSpan SlowBelow = ClockTicks.Span(10e-6), SlowUntil = ClockTicks.Span(25e-6);

        readonly TimeSpan _quick, _usual, _slow, _silence;
        readonly Random _random;
        readonly bool _isConstant;
        HeadsetTime? _last;
        int _quickLeft;
        bool _isSlow;

        /// <param name="usual">Configured interval from the start of one exchange to the start of the next.</param>
        /// <param name="silence">
        /// Time without exchanges after which the clock is in holdover and the next exchanges are quick. The slow interval is at most half of it.
        /// </param>
        /// <param name="random">
        /// Source of random numbers, which spread the exchanges over the steps of a coarse control clock. It must not be shared with other objects.
        /// </param>
        /// <param name="isConstant">Whether the configured pace always applies, as in the paper.</param>
        /// <param name="maySlow">Whether the pace may be slow. A step of either clock is then found only seconds later.</param>
        public ExchangePace(TimeSpan usual, TimeSpan silence, Random random, bool isConstant = false, bool maySlow = true)
        {
            _random = random;
            _isConstant = isConstant;
            _usual = usual;
            _quick = Min(usual, Max(MinInterval, new TimeSpan(usual.Ticks / QuickFactor)));
            _slow = !maySlow ? usual : Max(usual, Min(Min(MaxInterval, new TimeSpan(silence.Ticks / 2)), new TimeSpan(usual.Ticks * SlowFactor)));
            _silence = Max(silence, _slow + usual);
        }

        /// <summary>Returns the time from the start of the exchange that has just ended to the start of the next.</summary>
        /// <param name="clock">Synchroniser that has already received the ended exchange.</param>
        /// <param name="now">Current headset time, not earlier than in the last call.</param>
        public TimeSpan Next(ClockSynchroniser clock, HeadsetTime now)
        {
            if (_isConstant) return _usual;
            if (now - _last > _silence) _quickLeft = QuickAfterSilence;
            else if (_quickLeft > 0) _quickLeft--;
            _last = now;
            var isSynchronised = clock.ModelAt(now).State == ClockState.Synchronised;
            _isSlow = isSynchronised && clock.OffsetError < (_isSlow ? SlowUntil : SlowBelow);
            var isQuick = clock.Exchanges < (isSynchronised ? QuickAtStart : QuickUntilSynchronised) || _quickLeft > 0 || clock.IsStepSuspected;
            return (isQuick ? _quick : _isSlow ? _slow : _usual) + Dither(clock.Resolution);
        }

        // Without dither, all exchanges may fall into the same part of a coarse clock's step, which biases the estimated rate. The dither is
        // limited to the quick interval, so that an implausible resolution does not slow the pace. The dithered exchanges of several intervals then
        // cover a longer step.
        TimeSpan Dither(TimeSpan resolution) => new TimeSpan((long)(Min(resolution, _quick).Ticks * _random.NextDouble()));

        static TimeSpan Min(TimeSpan a, TimeSpan b) => a < b ? a : b;
        static TimeSpan Max(TimeSpan a, TimeSpan b) => a > b ? a : b;
    }
}
