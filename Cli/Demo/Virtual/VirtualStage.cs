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

    VirtualStage(DemoSettings settings, bool hasScene, IMotion sampled, TimeSpan clockError)
    {
        _settings = settings;
        _clock.Set(Start);
        var control = new VirtualClock(Start, ControlAhead, ControlSkew);
        _truth = new VirtualTruth(settings.Motion.Motions[0].Motion, control, Start, ControlSkew);
        var conditions = new VirtualCellSettings(settings.SamplingMs, settings.Acquisition.Min, settings.Acquisition.Max, 0, 0, settings.Network);
        _cell = new VirtualCell(
            sampled == null ? settings.Motion : new CellMotion(sampled), control, conditions, settings.Seed, Start,
            exchangeClock: new VirtualClock(Start, ControlAhead + clockError, ControlSkew));
        var session = DemoStage.SessionOf(settings, new ConnectionSettings("127.0.0.1", 1, 1));
        var samples = (int)(settings.Seconds * 1000 / settings.SamplingMs) + 1000;
        _headset = hasScene
            ? new DemoHeadset(settings.Robot, session, _clock, samples) : new SessionHeadset(settings.Robot, session, _clock, samples);
        _headset.Session.Described(settings.RobotText);
    }

    /// <param name="hasScene">
    /// Whether the headset plays the sample scene instead of only its session. A process can play only one scene at a time.
    /// </param>
    /// <param name="sampled">The motion that the cell samples; null to sample the true motion.</param>
    /// <param name="clockError">Error of the control clock in the sync exchanges.</param>
    public static DemoRun Play(DemoSettings settings, bool hasScene, IMotion sampled = null, TimeSpan clockError = default)
    {
        var stage = new VirtualStage(settings, hasScene, sampled, clockError);
        using (stage._headset) return stage.Run();
    }

    DemoRun Run()
    {
        var loop = new DemoFrameLoop(_settings, _headset, _clock, _truth, AdvanceTo);
        loop.Run((_, _) => { }, CancellationToken.None);
        return new DemoRun(
            _settings, _truth, loop.Frames, _headset.Log.ApplicationLatencies, _headset.Session.Statistics(_clock.Read),
            _headset.Session.Range?.Limit, _headset.Alarms)
        {
            Bodies = loop.Bodies, Signals = loop.Signals, Exchanges = _headset.Log.Exchanges(), BeyondLimits = _headset.Session.BeyondLimits,
        };
    }

    void AdvanceTo(HeadsetTime time)
    {
        _clock.Set(time);
        _cell.Run(time, _headset.Session);
    }
}
