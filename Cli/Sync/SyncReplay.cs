using Nowpose.Sync;

namespace Nowpose.Cli.Sync;

/// <summary>Feeds the exchanges of a log to the headset's clock synchroniser and returns its estimates.</summary>
sealed class SyncReplay(IClockEstimator estimator)
{
    readonly ClockSynchroniser _clock = new(estimator, ClockSettings.Default);
    readonly SortedDictionary<SyncExchangeFault, int> _dropped = [];

    /// <summary>Number of dropped exchanges for each fault.</summary>
    public IReadOnlyDictionary<SyncExchangeFault, int> Dropped => _dropped;

    public int Steps => _clock.Steps;

    /// <summary>Gets the estimate after each exchange, at the exchange's t4.</summary>
    public IEnumerable<SyncEstimate> AfterEach(IReadOnlyList<(long T4Nanoseconds, SyncExchange Exchange)> log)
    {
        foreach (var (t4, exchange) in log)
        {
            Add(exchange);
            yield return new SyncEstimate(t4, exchange.T4, _clock.ModelAt(exchange.T4));
        }
    }

    /// <summary>Gets the estimate at each instant, from the exchanges whose t4 is not later than the instant, in the order of t4.</summary>
    public IEnumerable<SyncEstimate> At(IReadOnlyList<long> instants, IReadOnlyList<(long T4Nanoseconds, SyncExchange Exchange)> log)
    {
        // A log of several connections may have an exchange after a later one.
        (long T4Nanoseconds, SyncExchange Exchange)[] ordered = [.. log.OrderBy(each => each.T4Nanoseconds)];
        var next = 0;
        foreach (var instant in instants)
        {
            for (; next < ordered.Length && ordered[next].T4Nanoseconds <= instant; next++)
                Add(ordered[next].Exchange);
            var now = HeadsetTime.FromNanoseconds(instant);
            yield return new SyncEstimate(instant, now, _clock.ModelAt(now));
        }
    }

    void Add(in SyncExchange exchange)
    {
        if (_clock.Add(exchange, out var fault) == SyncVerdict.Dropped)
            _dropped[fault] = _dropped.GetValueOrDefault(fault) + 1;
    }
}
