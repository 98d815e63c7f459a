using System.Net;
using Nowpose.Cli.Demo.Virtual;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;

namespace Nowpose.Cli.Demo;

/// <summary>Creates the cell, gateway, network and headset, plays a run with them, and disposes of them.</summary>
static class DemoStage
{
    /// <summary>Skew of the control clock relative to the headset clock: a typical difference between two quartz oscillators.</summary>
    const double ControlSkew = 37e-6;

    /// <summary>Name of the simulated headset, also in its recording.</summary>
    public const string HeadsetName = "demo";

    /// <summary>Time of the control clock when it is created. It is large, as if the control clock showed Unix time.</summary>
    static readonly ControlTime ControlEpoch = ControlTime.FromSeconds(1_700_000_000);

    /// <summary>Plays until the duration of the run has elapsed or the user cancels.</summary>
    /// <param name="recordingPath">Path of the headset's recording.</param>
    public static async Task<DemoRun> PlayAsync(DemoSettings settings, string recordingPath, CancellationToken cancel)
    {
        var run = settings.IsVirtual
            ? VirtualStage.Play(settings, recordingPath, cancel) : await PlayInRealTimeAsync(settings, recordingPath, cancel);
        if (run.RecordingProblem != null) await Console.Error.WriteLineAsync(ConsoleMessages.Line(run.RecordingProblem));
        return run;
    }

    static async Task<DemoRun> PlayInRealTimeAsync(DemoSettings settings, string recordingPath, CancellationToken cancel)
    {
        var control = new StopwatchControlClock(ControlEpoch, ControlSkew);
        var options = new GatewayOptions { SyncPort = 0, WebSocketPort = 0 };
        await using var gateway = await GatewayServer.StartAsync(options, control, cancellation: cancel);
        using var source = gateway.Hub.OpenSource();
        source.Describe(settings.RobotText);
        using var cell = new SimulatedCell(settings.Motion, control, Timing(settings), settings.Seed, settings.PublishesPlan);
        cell.PublishInto(gateway.Hub);
        using var syncRelay = new DelayRelay(gateway.SyncEndPoint, settings.Network, settings.Seed * 1000 + 1);
        using var webSocketRelay = new DelayRelay(gateway.WebSocketEndPoint, settings.Network, settings.Seed * 1000 + 501);
        var connection = new ConnectionSettings(IPAddress.Loopback.ToString(), syncRelay.Port, webSocketRelay.Port, headsetName: HeadsetName);
        var truth = new DemoTruth(control, cell);
        // Uses a separate thread, like a headset's frame loop: the thread pool has only two threads here, and the sockets need them.
        return await Task.Factory.StartNew(
            () => Play(settings, connection, truth, recordingPath, cancel),
            CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
    }

    static CellTiming Timing(DemoSettings settings) => new(
        TimeSpan.FromMilliseconds(settings.SamplingMs),
        TimeSpan.FromMilliseconds(settings.Acquisition.Min), TimeSpan.FromMilliseconds(settings.Acquisition.Max));

    /// <summary>Gets the settings of the headset's session. If there is a load but no profile, calibrates the display first.</summary>
    internal static SessionSettings SessionOf(DemoSettings settings, ConnectionSettings connection)
    {
        var session = new SessionSettings(
            connection, VisualisationLatency.FromMilliseconds(settings.GivenVisualisationMs), new PredictionSettings(settings.Predictor, blendMs: settings.BlendMs),
            clockEstimator: settings.Estimator, profile: ProfileOf(settings));
        return settings.HasConstantSyncInterval ? session.WithConstantSyncInterval() : session;
    }

    static LatencyProfile ProfileOf(DemoSettings settings)
    {
        if (!settings.IsRendered) return settings.Profile?.WithoutDisplay();
        return settings.Profile ?? (settings.Load == null ? null : DemoCalibration.Of(settings));
    }

    static DemoRun Play(
        DemoSettings settings, ConnectionSettings connection, DemoTruth truth, string recordingPath, CancellationToken cancel)
    {
        var session = SessionOf(settings, connection);
        var clock = new StopwatchHeadsetClock();
        using var headset = new DemoHeadset(
            settings.Robot, session, clock, (int)(settings.Seconds * 1000 / settings.SamplingMs) + 1000, recordingPath);
        using var never = new ManualResetEventSlim();
        var loop = new DemoFrameLoop(settings, headset, clock, truth, time => PreciseWait.While(() => time - clock.Now, never));
        ConsoleProgress.Run(settings.Seconds, report => loop.Run(report, cancel));
        var run = DemoRun.Of(settings, truth, loop, headset, clock.Now);
        return headset.Complaint is string complaint ? throw new DemoFailedException(DemoMessages.SceneError(complaint)) : run;
    }
}
