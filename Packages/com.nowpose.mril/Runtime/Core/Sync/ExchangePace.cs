using System;

namespace Nowpose.Sync
{
    /// <summary>
    /// When to exchange next: quickly while there is something to find out, that is at the start, after a step or a silence
    /// and while a step is suspected; slowly when the clock is known so well that more would not help; in between as set.
    /// One thread.
    /// </summary>
    sealed class ExchangePace
    {
        /// <summary>Least time between two exchanges that is gone down to: half of what a server bears.</summary>
        static readonly TimeSpan Shortest = TimeSpan.FromMilliseconds(20);

        /// <summary>Greatest that is gone up to: a sixth of the silence that a server bears.</summary>
        static readonly TimeSpan Longest = TimeSpan.FromSeconds(10);

        const int QuickFactor = 4, SlowFactor = 5;

        /// <summary>Quick exchanges after a start, and after a silence: five seconds, and a little more than one, at 200 ms as set.</summary>
        const int QuickAtStart = 100, QuickAfterSilence = 25;

        /// <summary>Quick exchanges at most while the clock is not synchronised yet: 50 s at 200 ms as set, then it goes on as set.</summary>
        const int QuickUntilSynchronised = 1000;

        /// <summary>
        /// Standard error of the offset below which it goes slowly, and above which no longer. A wired network reaches it,
        /// WiFi hardly ever: there more exchanges do help.
        /// </summary>
        static readonly TimeSpan Calm = ClockTicks.Span(10e-6), Uneasy = ClockTicks.Span(25e-6);

        readonly TimeSpan _quick, _usual, _slow, _silence;
        readonly Random _random;
        HeadsetTime? _last;
        int _quickLeft;
        bool _isCalm;

        /// <param name="usual">From the start of one exchange to the start of the next, as set; the others follow from it.</param>
        /// <param name="silence">
        /// A pause after which the clock is in holdover: the next exchanges are quick then, and two slow ones fit into it.
        /// </param>
        /// <param name="random">Spreads exchanges over the steps of a coarse control clock; this one's own.</param>
        public ExchangePace(TimeSpan usual, TimeSpan silence, Random random)
        {
            _random = random;
            _usual = usual;
            _quick = Least(usual, Greatest(Shortest, new TimeSpan(usual.Ticks / QuickFactor)));
            _slow = Greatest(usual, Least(Least(Longest, new TimeSpan(silence.Ticks / 2)), new TimeSpan(usual.Ticks * SlowFactor)));
            _silence = silence > _slow + usual ? silence : _slow + usual;
        }

        /// <summary>Time from the start of the exchange that has just ended to the start of the next.</summary>
        /// <param name="clock">Knows that exchange already.</param>
        /// <param name="now">Not before the last call's.</param>
        public TimeSpan Next(ClockSynchroniser clock, HeadsetTime now)
        {
            if (now - _last > _silence) _quickLeft = QuickAfterSilence;
            else if (_quickLeft > 0) _quickLeft--;
            _last = now;
            var isSynchronised = clock.ModelAt(now).State == ClockState.Synchronised;
            _isCalm = isSynchronised && clock.OffsetError < (_isCalm ? Uneasy : Calm);
            var isQuick = clock.Exchanges < (isSynchronised ? QuickAtStart : QuickUntilSynchronised) || _quickLeft > 0 || clock.IsStepSuspected;
            return (isQuick ? _quick : _isCalm ? _slow : _usual) + Dither(clock.Resolution);
        }

        // Exchanges that meet a coarse clock at the same part of its step again and again see its rate as their own.
        // No more than the quick pace, lest a wild resolution make it slow: several pauses together spread over a longer step too.
        TimeSpan Dither(TimeSpan resolution) => new TimeSpan((long)(Least(resolution, _quick).Ticks * _random.NextDouble()));

        static TimeSpan Least(TimeSpan a, TimeSpan b) => a < b ? a : b;
        static TimeSpan Greatest(TimeSpan a, TimeSpan b) => a > b ? a : b;
    }
}
