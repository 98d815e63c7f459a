using Nowpose.Cli.Messages;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Cli.Demo;

/// <summary>One run of the demo: the displayed values, and the truth to compare them with.</summary>
/// <param name="ApplicationLatencies">L_app of every sample that arrived while the clock was synchronised.</param>
/// <param name="Statistics">The runtime's own statistics at the end.</param>
/// <param name="Limit">The render time limit that the runtime was given; null for none.</param>
/// <param name="Alarms">Number of alarms of the runtime that the constant-latency range was left.</param>
sealed record DemoRun(
    DemoSettings Settings, IDemoTruth Truth, DemoFrames Frames, IReadOnlyList<TimeSpan> ApplicationLatencies, SessionStatistics Statistics,
    TimeSpan? Limit = null, int Alarms = 0)
{
    /// <summary>The displayed objects; null for none.</summary>
    public DemoBodies Bodies { get; init; }

    /// <summary>The sync exchanges that the runtime received, in order.</summary>
    public IReadOnlyList<SyncExchange> Exchanges { get; init; } = [];

    /// <summary>Gets the reason why the run has no valid result; null if it has one.</summary>
    /// <param name="needsClock">Whether a clock that never became synchronised is a failure, too.</param>
    public string Failure(bool needsClock = true)
    {
        var broken = Frames.FirstNotFinite();
        if (broken != null) return broken;
        var links = DemoMessages.Links(Statistics.SampleLink, Statistics.SyncLink);
        if (Statistics.Samples == 0) return DemoMessages.NoSample(Statistics.Dropped, links);
        if (!needsClock || Frames.Rows.Any(row => row.Clock.State == ClockState.Synchronised)) return null;
        var state = Statistics.Clock.State.Word();
        return DemoMessages.NoClock(state, Settings.Seconds, links);
    }
}
