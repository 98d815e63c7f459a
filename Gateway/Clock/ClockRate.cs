using Nowpose.Sync;

namespace Nowpose.Gateway.Clock;

/// <summary>
/// Finds a clock of the plant that does not run in real time, for example the clock of a simulation that runs at half speed. Thread-safe.
/// </summary>
/// <remarks>
/// Each exchange proves two bounds of the clock minus this machine's counter, for any delays. The clock runs at a wrong rate if the bounds prove two
/// facts: in a period, its rate deviated by more than time services usually need, and in each third of the period, it deviated by more than that of a
/// real clock. A step affects only one third. A new period begins when the clock has stopped, and when its rate is right again.
/// </remarks>
sealed class ClockRate
{
    /// <summary>Minimum deviation of a wrong rate. Time services usually slew a clock by less.</summary>
    const double MinDeviation = 2500e-6;

    /// <summary>Time after which a clock with a constant reading has stopped. That of a slow simulation stands still between two steps.</summary>
    static readonly TimeSpan MaxStandstill = TimeSpan.FromSeconds(1);

    /// <summary>Periods, shortest first. A longer one finds a smaller deviation behind a network with long delays.</summary>
    static readonly TimeSpan[] Periods = [TimeSpan.FromSeconds(5), TimeSpan.FromSeconds(20), TimeSpan.FromSeconds(60)];

    /// <summary>Time without a new proof after which a wrong rate is no longer known.</summary>
    static readonly TimeSpan MaxAge = 2 * Periods[^1];

    readonly Lock _lock = new();
    readonly List<Bounds> _recent = [];
    ControlTime _reading;
    HeadsetTime _readingBegan;
    volatile Proof _proof;

    /// <summary>
    /// The rate in seconds of the clock per second of the counter if it is wrong; null if it is right or not known yet. Without exchanges, the last
    /// result remains.
    /// </summary>
    public double? Wrong => _proof?.Rate;

    /// <summary>Adds a valid exchange.</summary>
    public void Add(in SyncExchange exchange)
    {
        lock (_lock)
        {
            if (IsAfterPause(exchange)) _recent.Clear();
            _recent.Add(new Bounds(exchange));
            _recent.RemoveRange(0, Math.Max(0, FirstOf(Periods[^1])));
            foreach (var period in Periods)
                if (FirstOf(period) is >= 0 and var first && TryJudge(first)) break;
            if (_proof is { } proof && exchange.T4 - proof.At > MaxAge) _proof = null;
        }
    }

    /// <summary>Forgets all exchanges and the result, because the next exchanges may be with another clock.</summary>
    public void Clear()
    {
        lock (_lock)
        {
            _recent.Clear();
            _proof = null;
        }
    }

    // Whether the previous exchange was long ago, or the clock has stopped.
    bool IsAfterPause(in SyncExchange exchange)
    {
        if (_recent.Count == 0 || exchange.T2 != _reading) (_reading, _readingBegan) = (exchange.T2, exchange.T4);
        return exchange.T1 - _readingBegan > MaxStandstill
            || _recent.Count > 0 && exchange.T4 - _recent[^1].At > ClockSettings.Default.HoldoverAfter;
    }

    // Returns the index of the last exchange that is at least this old; -1 if there is none.
    int FirstOf(TimeSpan period) => _recent.FindLastIndex(one => _recent[^1].At - one.At >= period);

    /// <summary>Updates the result from the exchanges beginning with the one of this index.</summary>
    /// <returns>False if they do not show whether the rate is right; the result then remains.</returns>
    bool TryJudge(int first)
    {
        var (start, third) = (_recent[first].At, (_recent[^1].At - _recent[first].At) / 3);
        var second = _recent.FindIndex(first, one => one.At - start >= third);
        var last = _recent.FindIndex(second, one => one.At - start >= 2 * third);
        var (begin, end) = (_recent.Take(first..second).MinBy(one => one.Width), _recent.Skip(last).MinBy(one => one.Width));
        var (min, max) = ((end.Low - begin.High) / (end.At - begin.At), (end.High - begin.Low) / (end.At - begin.At));
        var (isFast, isSlow) = (min > MinDeviation, max < -MinDeviation);
        if (!isFast && !isSlow)
        {
            if (Wrong is not { } before) return false;
            // A wide range of possible rates does not show that the wrong rate has ended.
            var limit = Math.Max(MinDeviation, Math.Abs(before - 1) / 2);
            if (min < -limit || max > limit) return false;
            _proof = null;
            // A longer period would still contain the wrong rate.
            _recent.RemoveRange(0, first);
            return true;
        }

        Range[] parts = [first..second, second..last, last..];
        if (!parts.Select(part => _recent.Take(part)).All(part => isFast ? IsFaster(part) : IsSlower(part))) return false;
        _proof = new Proof(_recent[^1].At, 1 + (min + max) / 2);
        return true;
    }

    // Whether the bounds show that the clock was, at least for a part of the time, slower than any real clock.
    static bool IsSlower(IEnumerable<Bounds> part) => Contradicts(part.Select(one => (one.Low + one.MaxChange, one.High + one.MaxChange)));

    // Like IsSlower, with the signs reversed, which also exchanges the lower and the upper bound.
    static bool IsFaster(IEnumerable<Bounds> part) => Contradicts(part.Select(one => (one.MaxChange - one.High, one.MaxChange - one.Low)));

    // Whether an upper bound is below an earlier lower bound of a value that cannot decrease.
    static bool Contradicts(IEnumerable<(TimeSpan Low, TimeSpan High)> bounds)
    {
        var least = TimeSpan.MinValue;
        foreach (var (low, high) in bounds)
        {
            if (high < least) return true;
            if (low > least) least = low;
        }

        return false;
    }

    /// <param name="At">Time of the last exchange that proved the rate.</param>
    sealed record Proof(HeadsetTime At, double Rate);

    /// <summary>The bounds of the clock's time minus the counter that one exchange proves.</summary>
    readonly struct Bounds
    {
        /// <summary>Assumed resolution of a clock that does not state one. The system clock of Windows can have steps of 15.6 ms.</summary>
        static readonly TimeSpan UnknownResolution = TimeSpan.FromMilliseconds(20);

        public Bounds(in SyncExchange exchange)
        {
            At = exchange.T4;
            var error = (exchange.Resolution == TimeSpan.Zero ? UnknownResolution : exchange.Resolution) / 2 + exchange.ServerErrorBound;
            Low = exchange.T3.SinceEpoch - exchange.T4.SinceEpoch - error;
            High = exchange.T2.SinceEpoch - exchange.T1.SinceEpoch + error;
        }

        public HeadsetTime At { get; }
        public TimeSpan Low { get; }
        public TimeSpan High { get; }
        public TimeSpan Width => High - Low;

        /// <summary>Maximum change of a real clock minus the counter since the start of the counter.</summary>
        public TimeSpan MaxChange => At.SinceEpoch * ClockLine.MaxSkew;
    }
}
