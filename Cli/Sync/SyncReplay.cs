using Nowpose.Sync;

namespace Nowpose.Cli.Sync;

/// <summary>
/// Feeds the exchanges of a log to the headset's clock synchroniser and returns its estimates. Each estimate depends only on the exchanges up to it,
/// also where the log shows the resolution of the control clock: it equals the last estimate of a log that ends there.
/// </summary>
sealed class SyncReplay(string estimator)
{
    readonly List<LoggedExchange> _known = [];
    readonly LoggedResolution _logged = new();
    readonly SortedDictionary<SyncExchangeFault, int> _dropped = [];
    ClockSynchroniser _clock = Create(estimator);
    TimeSpan _resolution;

    /// <summary>Number of dropped exchanges for each fault.</summary>
    public IReadOnlyDictionary<SyncExchangeFault, int> Dropped => _dropped;

    public int Steps => _clock.Steps;

    /// <summary>Gets the estimate after each exchange, at the exchange's t4.</summary>
    public IEnumerable<SyncEstimate> AfterEach(IReadOnlyList<LoggedExchange> log)
    {
        foreach (var each in log)
        {
            Add(each);
            yield return new SyncEstimate(each.T4Nanoseconds, each.Exchange.T4, _clock.ModelAt(each.Exchange.T4));
        }
    }

    /// <summary>Gets the estimate at each instant, from the exchanges whose t4 is not later than the instant, in the order of t4.</summary>
    public IEnumerable<SyncEstimate> At(IReadOnlyList<long> instants, IReadOnlyList<LoggedExchange> log)
    {
        // A log of several connections may have an exchange after a later one.
        LoggedExchange[] ordered = [.. log.OrderBy(each => each.T4Nanoseconds)];
        var next = 0;
        foreach (var instant in instants)
        {
            for (; next < ordered.Length && ordered[next].T4Nanoseconds <= instant; next++)
                Add(ordered[next]);
            var now = HeadsetTime.FromNanoseconds(instant);
            yield return new SyncEstimate(instant, now, _clock.ModelAt(now));
        }
    }

    void Add(in LoggedExchange exchange)
    {
        _known.Add(exchange);
        var resolution = exchange.Stamps is { } stamps ? _logged.Add(stamps) : TimeSpan.Zero;
        if (resolution == _resolution)
        {
            Feed(exchange);
            return;
        }
        // The earlier exchanges were used without half the resolution. The clock itself has not changed, so this is not a step.
        _resolution = resolution;
        _clock = Create(estimator);
        _dropped.Clear();
        foreach (var each in _known) Feed(each);
    }

    void Feed(in LoggedExchange exchange)
    {
        if (_clock.Add(exchange.ExchangeWith(_resolution), out var fault) == SyncVerdict.Dropped)
            _dropped[fault] = _dropped.GetValueOrDefault(fault) + 1;
    }

    static ClockSynchroniser Create(string estimator) => new(ClockEstimators.Create(estimator), ClockSettings.Default);
}
