using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Simulation.Work;

namespace Nowpose.Cli.Demo.Virtual;

/// <summary>Plays a run in virtual time with the demo's display, frame loop and score, a virtual cell and a virtual network.</summary>
sealed class VirtualStage
{
    const double ControlSkew = 37e-6;

    /// <summary>Time by which the control clock is ahead of the headset clock.</summary>
    static readonly TimeSpan ControlAhead = TimeSpan.FromSeconds(50);

    static readonly HeadsetTime Start = HeadsetTime.FromSeconds(100);

    readonly DemoSettings _settings;
    readonly VirtualHeadsetClock _clock = new();
    readonly VirtualTruth _truth;
    readonly VirtualCell _cell;
    readonly IDemoHeadset _headset;

    VirtualStage(DemoSettings settings, bool hasScene, IMotion sampled = null, TimeSpan clockError = default, string recordingPath = null)
    {
        _settings = settings with { IsVirtual = true };
        _clock.Set(Start);
        var control = new VirtualClock(Start, ControlAhead, ControlSkew);
        _truth = new VirtualTruth(settings.Motion.Motions[0].Motion, control, Start, ControlSkew);
        var conditions = new VirtualCellSettings(settings.SamplingMs, settings.Acquisition.Min, settings.Acquisition.Max, 0, 0, settings.Network);
        _cell = new VirtualCell(
            sampled == null ? settings.Motion : new CellMotion(sampled), control, conditions, settings.Seed, Start,
            exchangeClock: new VirtualClock(Start, ControlAhead + clockError, ControlSkew))
        {
            PlanLag = settings.PublishesPlan ? TimeSpan.Zero : null,
        };
        var session = DemoStage.SessionOf(settings, new ConnectionSettings("127.0.0.1", 1, 1, headsetName: DemoStage.HeadsetName));
        var samples = (int)(settings.Seconds * 1000 / settings.SamplingMs) + 1000;
        _headset = hasScene
            ? new DemoHeadset(settings.Robot, session, _clock, samples) : new SessionHeadset(settings.Robot, session, _clock, samples, recordingPath);
        _headset.Session.Described(settings.RobotText);
    }

    /// <summary>Plays a run without a scene until its end or until the user cancels, and shows its progress.</summary>
    /// <param name="recordingPath">Path of the session's recording; null to record nothing.</param>
    public static DemoRun Play(DemoSettings settings, string recordingPath, CancellationToken cancel)
    {
        var stage = new VirtualStage(settings, hasScene: false, recordingPath: recordingPath);
        DemoRun run = null;
        using (stage._headset)
            ConsoleProgress.Run("playing", "s", (int)settings.Seconds, report => run = stage.Run(seconds => report((int)seconds), cancel));
        return run;
    }

    /// <summary>Plays a run.</summary>
    /// <param name="hasScene">
    /// Whether the headset plays the sample scene instead of only its session. A process can play only one scene at a time.
    /// </param>
    /// <param name="sampled">The motion that the cell samples; null to sample the true motion.</param>
    /// <param name="clockError">Error of the control clock in the sync exchanges.</param>
    public static DemoRun Play(DemoSettings settings, bool hasScene, IMotion sampled = null, TimeSpan clockError = default)
    {
        var stage = new VirtualStage(settings, hasScene, sampled, clockError);
        using (stage._headset) return stage.Run(_ => { }, CancellationToken.None);
    }

    // The status text of the loop is not used, because it would read the clock, which advances it.
    DemoRun Run(Action<double> report, CancellationToken cancel)
    {
        var loop = new DemoFrameLoop(_settings, _headset, _clock, _truth, AdvanceTo);
        loop.Run((seconds, _) => report(seconds), cancel);
        return DemoRun.Of(_settings, _truth, loop, _headset, _clock.Read);
    }

    void AdvanceTo(HeadsetTime time)
    {
        _clock.Set(time);
        _cell.Run(time, _headset.Session);
    }
}
