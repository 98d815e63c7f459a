using Nowpose.Kinematics;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Cli.Demo;

/// <summary>The data of one run of the demo: the displayed values, and the true values for comparison.</summary>
/// <param name="ApplicationLatencies">L_app of each sample that arrived while the clock was synchronised.</param>
/// <param name="Statistics">The runtime's own statistics at the end of the run.</param>
/// <param name="Limit">Render time limit that the runtime used; null if there was none.</param>
/// <param name="Alarms">Number of alarms that the runtime raised because the render time left the constant-latency range.</param>
sealed record DemoRun(
    DemoSettings Settings, IDemoTruth Truth, DemoFrames Frames, IReadOnlyList<TimeSpan> ApplicationLatencies, SessionStatistics Statistics,
    TimeSpan? Limit = null, int Alarms = 0)
{
    /// <summary>The displayed objects; null if the cell has none.</summary>
    public DemoBodies Bodies { get; init; }

    /// <summary>The displayed signals; null if the cell has none.</summary>
    public DemoSignals Signals { get; init; }

    /// <summary>The sync exchanges that the runtime received, in order.</summary>
    public IReadOnlyList<SyncExchange> Exchanges { get; init; } = [];

    /// <summary>The joints whose samples were outside their limits, and therefore drawn at the limit.</summary>
    public IReadOnlyList<JointBeyondLimits> BeyondLimits { get; init; } = [];

    /// <summary>Reason why the recording of the session ended early, in one line; null if it did not.</summary>
    public string RecordingProblem { get; init; }

    /// <summary>Number of lines that the recording of the session lost.</summary>
    public long LostLines { get; init; }

    /// <summary>Ends the recording, and collects the data of a run that has ended.</summary>
    /// <param name="now">Headset time at the end of the run.</param>
    public static DemoRun Of(DemoSettings settings, IDemoTruth truth, DemoFrameLoop loop, IDemoHeadset headset, HeadsetTime now)
    {
        var (problem, lostLines) = headset.Recording.End();
        return new DemoRun(
            settings, truth, loop.Frames, headset.Log.ApplicationLatencies, headset.Session.Statistics(now), headset.Session.Range?.Limit,
            headset.Alarms)
        {
            Bodies = loop.Bodies, Signals = loop.Signals, Exchanges = headset.Log.Exchanges(), BeyondLimits = headset.Session.BeyondLimits,
            RecordingProblem = problem, LostLines = lostLines,
        };
    }

    /// <summary>Message that many frames began late; null if they did not.</summary>
    public string LateNote => Frames.Late() is { AreMany: true } many ? DemoMessages.LateFrames(many) : null;

    /// <summary>Gets the reasons why the results or the recording can mislead a reader, in one line each; null if there are none.</summary>
    /// <param name="interruption">Message that the run is incomplete; null if it is complete.</param>
    /// <param name="ofOthers">Notes about further repeats, null for a repeat without one; null for one run.</param>
    public IReadOnlyList<string> Notes(string interruption, IEnumerable<string> ofOthers = null)
    {
        var lost = LostLines > 0 ? DemoMessages.LinesLost(LostLines) : null;
        string[] notes =
        [
            interruption, LateNote, .. ofOthers ?? [], .. Settings.MotionWarnings, .. BeyondLimits.Select(joint => joint.Words), RecordingProblem, lost,
        ];
        return notes.All(note => note == null) ? null : [.. notes.Where(note => note != null)];
    }

    /// <summary>Gets the reason why the run is invalid; null if it is valid.</summary>
    /// <param name="needsClock">Whether a run is also invalid if the clock was never synchronised.</param>
    public string Failure(bool needsClock = true)
    {
        var broken = Frames.FirstNotFinite() ?? Bodies?.FirstNotFinite();
        if (broken != null) return broken;
        var links = DemoMessages.Links(Statistics.SampleLink, Statistics.SyncLink);
        if (Statistics.Samples == 0) return DemoMessages.NoSample(Statistics.Dropped, links);
        if (!needsClock || Frames.Rows.Any(row => row.Clock.State == ClockState.Synchronised)) return null;
        var state = Statistics.Clock.State.Word();
        return DemoMessages.NoClock(state, Settings.Seconds, links);
    }
}
