using Nowpose.Session;

namespace Nowpose.Cli.Demo;

/// <summary>One run of the main job: what was displayed, and the truth to compare it with.</summary>
/// <param name="ApplicationLatencies">L_app of every sample that arrived while the clock was known.</param>
/// <param name="Statistics">The runtime's own view at the end.</param>
/// <param name="Limit">The render time limit that the runtime was told; null for none.</param>
/// <param name="Alarms">How often the runtime said that the constant-latency range was left.</param>
sealed record DemoRun(
    DemoSettings Settings, IDemoTruth Truth, DemoFrames Frames, IReadOnlyList<TimeSpan> ApplicationLatencies, SessionStatistics Statistics,
    TimeSpan? Limit = null, int Alarms = 0)
{
    /// <summary>Why the run proves nothing; null when it does.</summary>
    public string Failure()
    {
        var broken = Frames.FirstNotFinite();
        if (broken != null) return broken;
        var links = $"joint positions {Statistics.SampleLink}; clock sync {Statistics.SyncLink}";
        if (Statistics.Samples == 0) return $"no sample was used, {Statistics.Dropped} were dropped; {links}";
        if (Frames.Rows.Any(row => row.Clock.State == ClockState.Synchronised)) return null;
        var state = Statistics.Clock.State.Word();
        return FormattableString.Invariant($"the clock was still {state} after {Settings.Seconds} s: run longer (--seconds); {links}");
    }
}
