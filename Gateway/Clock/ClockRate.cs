using Nowpose.Sync;

namespace Nowpose.Gateway.Clock;

/// <summary>
/// Finds a clock of the plant whose rate differs from that of this machine's counter by more than two real clocks can differ, for example the clock
/// of a simulation that runs at half speed. Thread-safe.
/// </summary>
/// <remarks>
/// Each exchange proves two bounds of the clock minus the counter, for any delays. Bounds that no clock with a permitted rate can have prove that the
/// rate was wrong between them. The clock runs at a wrong rate if this is so in each third of a period and for the whole period. A step affects only
/// one third. A new period begins when the clock has stopped, and when its rate is right again.
/// </remarks>
sealed class ClockRate
{
    /// <summary>Periods, shortest first. A longer one finds a smaller deviation behind a network with long delays.</summary>
    static readonly TimeSpan[] Periods = [TimeSpan.FromSeconds(5), TimeSpan.FromSeconds(20), TimeSpan.FromSeconds(60)];

    const int Parts = 3;

    readonly Lock _lock = new();
    readonly List<Bounds> _recent = [];
    double? _wrong;

    /// <summary>
    /// Returns the rate in seconds of the clock per second of the counter if it is wrong; null if it is right, not known yet, or no longer measured.
    /// </summary>
    public double? WrongAt(HeadsetTime now)
    {
        lock (_lock)
            return _recent.Count > 0 && now - _recent[^1].At <= ClockSettings.Default.HoldoverAfter ? _wrong : null;
    }

    /// <summary>Adds a valid exchange.</summary>
    public void Add(in SyncExchange exchange)
    {
        var added = new Bounds(exchange);
        lock (_lock)
        {
            if (_recent.Count > 0 && added.IsAfterPause(_recent[^1])) _recent.Clear();
            _recent.Add(added);
            _recent.RemoveRange(0, Math.Max(0, FirstOf(Periods[^1])));
            foreach (var period in Periods)
                if (FirstOf(period) is >= 0 and var first && TryJudge(first)) break;
        }
    }

    // Returns the index of the last exchange that is at least this old; -1 if there is none.
    int FirstOf(TimeSpan period) => _recent.FindLastIndex(one => _recent[^1].At - one.At >= period);

    /// <summary>Updates the result from the exchanges beginning with the one of this index.</summary>
    /// <returns>False if they do not show whether the rate is right; the result then remains.</returns>
    bool TryJudge(int first)
    {
        var (start, length) = (_recent[first].At, _recent[^1].At - _recent[first].At);
        var parts = _recent.Skip(first).ToLookup(one => Math.Min(Parts - 1, (int)(Parts * (one.At - start) / length)));
        var (begin, end) = (parts[0].MinBy(one => one.Width), parts[Parts - 1].MinBy(one => one.Width));
        var (min, max) = ((end.Low - begin.High) / (end.At - begin.At), (end.High - begin.Low) / (end.At - begin.At));
        var (isFast, isSlow) = (min > ClockLine.MaxSkew, max < -ClockLine.MaxSkew);
        if (!isFast && !isSlow)
        {
            // A wide range of possible rates does not show that the wrong rate has ended.
            if (_wrong is not { } before || max - min >= Math.Abs(before - 1) / 2) return false;
            _wrong = null;
            // A longer period would still contain the wrong rate.
            _recent.RemoveRange(0, first);
            return true;
        }

        if (parts.Count < Parts || !parts.All(part => isFast ? IsFaster(part) : IsSlower(part))) return false;
        _wrong = 1 + (min + max) / 2;
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

    /// <summary>The bounds of the clock's time minus the counter that one exchange proves.</summary>
    readonly struct Bounds
    {
        readonly HeadsetTime _asked;
        readonly ControlTime _received, _sent;
        readonly TimeSpan _resolution;

        public Bounds(in SyncExchange exchange)
        {
            (_asked, At) = (exchange.T1, exchange.T4);
            (_received, _sent, _resolution) = (exchange.T2, exchange.T3, exchange.Resolution);
            var error = exchange.Resolution / 2 + exchange.ServerErrorBound;
            Low = exchange.T3.SinceEpoch - exchange.T4.SinceEpoch - error;
            High = exchange.T2.SinceEpoch - exchange.T1.SinceEpoch + error;
        }

        public HeadsetTime At { get; }
        public TimeSpan Low { get; }
        public TimeSpan High { get; }
        public TimeSpan Width => High - Low;

        /// <summary>Maximum change of a real clock minus the counter since the start of the counter.</summary>
        public TimeSpan MaxChange => At.SinceEpoch * ClockLine.MaxSkew;

        /// <summary>
        /// Whether the previous exchange was long ago, or the clock has not advanced since then although, according to its resolution, it should
        /// have.
        /// </summary>
        public bool IsAfterPause(in Bounds previous) =>
            At - previous.At > ClockSettings.Default.HoldoverAfter
            || (_received - previous._sent).Duration() <= _resolution && _asked - previous.At > 2 * _resolution;
    }
}
