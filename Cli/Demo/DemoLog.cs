using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Cli.Demo;

/// <summary>Collects the sync exchanges and the application latencies of a session.</summary>
sealed class DemoLog
{
    const int ExpectedExchanges = 4096;

    readonly Lock _gate = new();
    readonly List<SyncExchange> _exchanges = new(ExpectedExchanges);

    // Has the capacity for all samples, so that it does not allocate during frames, whose allocations are measured.
    readonly List<TimeSpan> _latencies;

    /// <param name="samples">Expected number of samples. More samples are accepted.</param>
    public DemoLog(int samples) => _latencies = new List<TimeSpan>(samples);

    /// <summary>L_app of each sample that arrived while the clock was synchronised.</summary>
    public IReadOnlyList<TimeSpan> ApplicationLatencies => _latencies;

    /// <summary>Gets a copy of the sync exchanges of the session, in order.</summary>
    public IReadOnlyList<SyncExchange> Exchanges()
    {
        lock (_gate) return [.. _exchanges];
    }

    /// <summary>Starts to collect from a session. Discards the exchanges of the previous session.</summary>
    public void Follow(CompensationSession session)
    {
        lock (_gate) _exchanges.Clear();
        session.Clock.Judged += OnExchange;
        session.Intake.SampleTaken += (_, latency) =>
        {
            if (latency.HasValue) _latencies.Add(latency.Value);
        };
    }

    // Called on the connection's thread.
    void OnExchange(in SyncExchange exchange, SyncVerdict verdict, SyncExchangeFault fault)
    {
        if (verdict == SyncVerdict.Dropped) return;
        lock (_gate) _exchanges.Add(exchange);
    }
}
