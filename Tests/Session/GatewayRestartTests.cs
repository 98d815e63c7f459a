using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation.Work;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Session;

/// <summary>Tests a session during which the gateway stops and starts again, as after an update or a power failure.</summary>
public class GatewayRestartTests
{
    /// <summary>Less than half of the smallest step, so that an estimate of the clock before the step exceeds it.</summary>
    static readonly TimeSpan ClockTolerance = TimeSpan.FromMilliseconds(40);

    [TestCase(0)]
    [TestCase(0.1)]
    [TestCase(-5000)]
    public async Task Session_GatewayRestarts_ReconnectsAndSynchronisesAgain(double clockStepSeconds)
    {
        var robot = RobotFiles.Load("youbot");
        var clock = StopwatchControlClock.FromUnixTime();
        using var cell = Cell(clock);
        using ReservedPort sync = new(), positions = new();
        var (syncPort, webSocketPort) = (sync.Port, positions.Port);
        var gateway = await StartAsync(syncPort, webSocketPort, clock, cell);
        var headsetClock = new StopwatchHeadsetClock();
        using var session = new CompensationSession(
            new SessionSettings(
                new ConnectionSettings("127.0.0.1", syncPort, webSocketPort), new VisualisationLatency(TimeSpan.FromMilliseconds(40))),
            robot, headsetClock);
        session.Connect();
        await Soon.BecomesAsync(() => Tick(session, headsetClock) == PoseState.Current, "current before");

        await gateway.DisposeAsync();
        cell.Dispose();
        await Soon.BecomesAsync(() => Tick(session, headsetClock) == PoseState.Held, "held while the gateway is gone");
        var held = session.Tick(headsetClock.Now).Joints.ToArray();
        await Soon.BecomesAsync(() => Links(session, headsetClock, LinkState.Waiting), "both links waiting");
        Assert.That(session.Tick(headsetClock.Now).Joints.ToArray(), Is.EqualTo(held).Within(1e-6), "the pose is held, except for the rest of the blend");

        var newClock = clockStepSeconds == 0 ? clock : new StopwatchControlClock(clock.Now + TimeSpan.FromSeconds(clockStepSeconds));
        using var newCell = Cell(newClock);
        await using var newGateway = await StartAsync(syncPort, webSocketPort, newClock, newCell);
        var took = await Soon.BecomesAsync(() => Links(session, headsetClock, LinkState.Connected), "both links connected");
        await Soon.BecomesAsync(() => Tick(session, headsetClock) == PoseState.Current, "current after");
        await Soon.BecomesAsync(() => IsRight(session, headsetClock, newClock), "synchronised to the new clock");

        TestContext.Out.WriteLine($"both links connected after {took.TotalSeconds:0.00} s");
        Assert.That(session.Clock.Steps, clockStepSeconds == 0 ? Is.Zero : Is.GreaterThan(0));
    }

    static SimulatedCell Cell(IControlClock clock) => new(
        new CellMotion(new PickAndPlaceMotion(RobotFiles.Load("youbot"))), clock,
        new CellTiming(TimeSpan.FromMilliseconds(50), TimeSpan.FromMilliseconds(10), TimeSpan.FromMilliseconds(20)), seed: 1);

    static async Task<GatewayServer> StartAsync(int syncPort, int webSocketPort, IControlClock clock, SimulatedCell cell)
    {
        var gateway = await GatewayServer.StartAsync(new GatewayOptions { SyncPort = syncPort, WebSocketPort = webSocketPort }, clock);
        cell.PublishInto(gateway.Hub);
        return gateway;
    }

    static PoseState Tick(CompensationSession session, IHeadsetClock clock) => session.Tick(clock.Now).State;

    static bool Links(CompensationSession session, IHeadsetClock clock, LinkState state)
    {
        session.Tick(clock.Now);
        var statistics = session.Statistics(clock.Now);
        return statistics.SyncLink.State == state && statistics.SampleLink.State == state;
    }

    static bool IsRight(CompensationSession session, IHeadsetClock clock, StopwatchControlClock control)
    {
        session.Tick(clock.Now);
        var model = session.Clock.ModelAt(clock.Now);
        if (model.State != ClockState.Synchronised) return false;
        var (headset, truth) = (clock.Now, control.Now);
        return (model.ToControl(headset) - truth).Duration() < ClockTolerance;
    }
}
