using Nowpose.Cli.Demo;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Session;
using Nowpose.Simulation;

namespace Nowpose.Unity.Tests.Demo;

/// <summary>The main job in virtual time: the demo's own calibration, display, scene, frame loop and score, fed by a virtual cell.</summary>
sealed class VirtualDemo : IDemoTruth, IDisposable
{
    const double StartSeconds = 100;
    const double ControlSkew = 37e-6;

    readonly SteppedClock _clock = new();
    readonly IMotion _motion;
    readonly HeadsetTime _start;
    readonly VirtualClock _control;
    readonly VirtualCell _cell;
    readonly DemoHeadset _headset;

    VirtualDemo(DemoSettings settings, SessionSettings session)
    {
        _clock.Set(StartSeconds);
        _start = _clock.Read;
        _motion = settings.Motion;
        _control = new VirtualClock(_start, TimeSpan.FromSeconds(50), ControlSkew);
        _cell = new VirtualCell(
            _motion, _control,
            new VirtualCellSettings(settings.SamplingMs, settings.Acquisition.Min, settings.Acquisition.Max, 0, 0, settings.Network),
            settings.Seed, _start);
        _headset = new DemoHeadset(settings.Robot, session, _clock, 1000);
        _headset.Session.Described(settings.RobotText);
    }

    /// <param name="vertices">Vertices of the load; null for a display without a load.</param>
    /// <param name="profile">The profile given to the runtime; null for the demo's own calibration.</param>
    public static DemoRun Play(int? vertices, int seed, double seconds = 20, LatencyProfile profile = null)
    {
        var robot = RobotFiles.Load("youbot", out var urdf);
        var settings = new DemoSettings
        {
            Seconds = seconds, Network = NetworkProfile.Wifi, Robot = robot, RobotText = urdf, Motion = new PickAndPlaceMotion(robot),
            Predictor = Predictors.Default, SamplingMs = 50, Acquisition = new(55, 105), VisualisationMs = 40, Load = vertices, Seed = seed,
            Profile = profile,
        };
        using var demo = new VirtualDemo(settings, DemoStage.SessionOf(settings, new ConnectionSettings("127.0.0.1", 1, 1)));
        return demo.Run(settings);
    }

    public void Dispose() => _headset.Dispose();

    DemoRun Run(DemoSettings settings)
    {
        var loop = new DemoFrameLoop(settings, _headset, _clock, this, GoOnTo);
        loop.Run((_, _) => { }, CancellationToken.None);
        return new DemoRun(
            settings, this, loop.Frames, _headset.ApplicationLatencies, _headset.Session.Statistics(_clock.Read),
            _headset.Session.Range?.Limit, _headset.Alarms);
    }

    void GoOnTo(HeadsetTime time)
    {
        _clock.Set(time.SinceEpoch.TotalSeconds);
        _cell.Run(time, _headset.Session);
    }

    ControlTime IDemoTruth.ControlAt(HeadsetTime t) => _control.At(t);

    // The cell takes headset time. The skew makes an error of less than 0.1 µs.
    void IDemoTruth.JointsAt(ControlTime t, Span<double> positions) => _cell.TruthAt(HeadsetAt(t), positions);

    int IDemoTruth.CycleAt(ControlTime t) => (int)((HeadsetAt(t) - _start).TotalSeconds / _motion.CycleSeconds);

    HeadsetTime HeadsetAt(ControlTime t) => _start + (t - _control.At(_start)) / (1 + ControlSkew);
}
