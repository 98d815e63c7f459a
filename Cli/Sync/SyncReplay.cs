using Nowpose.Sync;

namespace Nowpose.Cli.Sync;

/// <summary>Feeds a log to the headset's own clock synchroniser and returns its estimates.</summary>
sealed class SyncReplay(IClockEstimator estimator)
{
    readonly ClockSynchroniser _clock = new(estimator, ClockSettings.Default);
    readonly SortedDictionary<SyncExchangeFault, int> _dropped = [];

    /// <summary>Number of dropped exchanges by fault.</summary>
    public IReadOnlyDictionary<SyncExchangeFault, int> Dropped => _dropped;

    public int Steps => _clock.Steps;

    /// <summary>Gets one estimate per exchange, at its t4.</summary>
    public IEnumerable<SyncBelief> AfterEach(IReadOnlyList<(long T4Nanoseconds, SyncExchange Exchange)> log)
    {
        foreach (var (t4, exchange) in log)
        {
            Add(exchange);
            yield return new SyncBelief(t4, exchange.T4, _clock.ModelAt(exchange.T4));
        }
    }

    /// <summary>Gets one estimate per instant, from the exchanges with t4 up to it.</summary>
    public IEnumerable<SyncBelief> At(IReadOnlyList<long> instants, IReadOnlyList<(long T4Nanoseconds, SyncExchange Exchange)> log)
    {
        var next = 0;
        foreach (var instant in instants)
        {
            for (; next < log.Count && log[next].T4Nanoseconds <= instant; next++)
                Add(log[next].Exchange);
            var now = HeadsetTime.FromNanoseconds(instant);
            yield return new SyncBelief(instant, now, _clock.ModelAt(now));
        }
    }

    void Add(in SyncExchange exchange)
    {
        if (_clock.Add(exchange, out var fault) == SyncVerdict.Dropped)
            _dropped[fault] = _dropped.GetValueOrDefault(fault) + 1;
    }
}
