using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Plants;
using Nowpose.Headless.Tests.Gateway;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation.Work;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Ros;

/// <summary>Tests a headset that is connected to a rosbridge server without a gateway, with the clock of /rosapi/get_time.</summary>
public class RosDirectTests
{
    readonly StopwatchHeadsetClock _headsetClock = new();
    StopwatchControlClock _control;
    RosGraph _graph;
    RosbridgeDouble _rosbridge;
    SimulatedCell _cell;
    CompensationSession _session;

    void Start(RosFlavour flavour, TimeSpan resolution = default, TimeSpan before = default, TimeSpan after = default, bool hasRosapi = true,
        string rosNamespace = "")
    {
        _control = new StopwatchControlClock(ControlTime.FromSeconds(1_700_000_000), 20e-6)
        { Resolution = resolution == default ? new TimeSpan(1) : resolution };
        _graph = new RosGraph(flavour, _control) { HasRosapi = hasRosapi, Namespace = rosNamespace };
        _rosbridge = new RosbridgeDouble(_graph) { BeforeReading = before, AfterReading = after };
        _session = NewSession(_rosbridge.Port);
        _session.Connect();
    }

    CompensationSession NewSession(int port, int syncPort = ProtocolLimits.SyncPort) => new(
        new SessionSettings(
            new ConnectionSettings("127.0.0.1", syncPort, port, headsetName: "left", clockSource: ControlClockSource.RosTime),
            new VisualisationLatency(TimeSpan.FromMilliseconds(40))),
        RobotFiles.Load("youbot"), _headsetClock);

    void Move()
    {
        var form = _graph.Flavour == RosFlavour.Ros1 ? RosTimeForm.Secs : RosTimeForm.Sec;
        _cell = new SimulatedCell(
            new CellMotion(new PickAndPlaceMotion(RobotFiles.Load("youbot"))), _control,
            new CellTiming(TimeSpan.FromMilliseconds(50), TimeSpan.FromMilliseconds(10), TimeSpan.FromMilliseconds(20)), seed: 1);
        var hub = new MessageHub();
        hub.Subscribe(RosTopics.JointStates, message =>
            _graph.Publish(RosTopics.JointStates, RosTopics.JointStateType, System.Text.Encoding.UTF8.GetString(message.Utf8(form).Span)));
        _cell.PublishInto(hub);
    }

    [TearDown]
    public void Stop()
    {
        _session?.Dispose();
        _cell?.Dispose();
        _rosbridge?.Dispose();
        _cell = null;
    }

    PoseState Tick() => _session.Tick(_headsetClock.Now).State;

    // Both clocks use the same counter, so their times at one count are known.
    TimeSpan ClockError(out ClockModel model)
    {
        var count = Stopwatch.GetTimestamp();
        var headset = _headsetClock.At(count);
        model = _session.Clock.ModelAt(headset);
        return model.ToControl(headset) - _control.AtCount(count);
    }

    Task SynchronisedAsync() => Soon.BecomesAsync(
        () => { Tick(); return _session.Clock.ModelAt(_headsetClock.Now).State == ClockState.Synchronised; }, "synchronised");

    [TestCase(RosFlavour.Ros1)]
    [TestCase(RosFlavour.Ros2)]
    public async Task Session_ConnectedToRosbridge_ShowsTheRobotAndSynchronises(RosFlavour flavour)
    {
        Start(flavour);
        _graph.Publish(
            RosTopics.RobotDescription, RosTopics.StringType,
            RosbridgeWriter.Publish(RosTopics.RobotDescription, new StringMessage(RobotFiles.LoadText("youbot"))), isLatched: true);
        Move();

        await Soon.BecomesAsync(() => Tick() == PoseState.Current, "current");
        await Soon.BecomesAsync(() => _session.SyncLink.State == LinkState.Connected, "the clock is connected");

        var error = ClockError(out var model);
        TestContext.Out.WriteLine($"{flavour}: clock off by {error.TotalMilliseconds:F3} ms, bound {model.ErrorBound.TotalMilliseconds:F3} ms");
        Assert.That(error.Duration(), Is.LessThanOrEqualTo(model.ErrorBound));
        await Soon.BecomesAsync(() => _session.RobotDescriptionMatch == RobotDescriptionMatch.Same, "the description");
        await Soon.BecomesAsync(() => _graph.Published.Any(sent => sent.Topic == RosTopics.Diagnostics), "the headset's diagnostics");
        Assert.That(_graph.Log, Is.Empty, "rosbridge reported no error");
    }

    [Test]
    public async Task Connect_RosTime_OpensNoSeparateClockConnection()
    {
        Start(RosFlavour.Ros2);
        using var syncPort = new TcpListener(IPAddress.Loopback, 0);
        syncPort.Start();
        using var session = NewSession(_rosbridge.Port, ((IPEndPoint)syncPort.LocalEndpoint).Port);

        session.Connect();
        await Soon.BecomesAsync(() => session.Clock.ModelAt(_headsetClock.Now).State == ClockState.Synchronised, "synchronised");

        Assert.That(syncPort.Pending(), Is.False);
    }

    [TestCase(20, 0)]
    [TestCase(0, 20)]
    [TestCase(10, 10)]
    public async Task Clock_AsymmetricServerDelay_ErrorIsWithinItsBound(int beforeMs, int afterMs)
    {
        Start(RosFlavour.Ros2, before: TimeSpan.FromMilliseconds(beforeMs), after: TimeSpan.FromMilliseconds(afterMs));

        await Soon.BecomesAsync(() => _session.Clock.Exchanges > 20, "exchanges");

        var error = ClockError(out var model);
        TestContext.Out.WriteLine(
            $"{beforeMs} ms before and {afterMs} ms after: off by {error.TotalMilliseconds:F3} ms, bound {model.ErrorBound.TotalMilliseconds:F3} ms");
        Assert.That(error.Duration(), Is.LessThanOrEqualTo(model.ErrorBound));
        Assert.That(model.ErrorBound.TotalMilliseconds, Is.GreaterThan(9), "the error bound includes half the duration of a call");
    }

    [Test]
    public async Task Clock_SimulatedTimeInSteps_HasTheResolutionOfTheSteps()
    {
        var step = TimeSpan.FromMilliseconds(10);
        Start(RosFlavour.Ros2, resolution: step);

        await Soon.BecomesAsync(() => _session.Clock.Exchanges > 30, "exchanges");

        // The model estimates the time between the steps. The time that the clock shows is up to one step behind.
        var error = ClockError(out var model);
        Assert.That(_session.Clock.Resolution, Is.EqualTo(step));
        Assert.That(error, Is.InRange(-model.ErrorBound, model.ErrorBound + step));
    }

    [Test]
    public async Task Exchanges_SlowServer_DoNotOverlap()
    {
        Start(RosFlavour.Ros1, before: TimeSpan.FromMilliseconds(120));

        await Soon.BecomesAsync(() => _session.Clock.Exchanges > 10, "exchanges");

        Assert.That(_rosbridge.MaxInFlight, Is.EqualTo(1));
    }

    [Test]
    public async Task Exchanges_UnexpectedAnswers_AreCountedAndIgnored()
    {
        Start(RosFlavour.Ros2);
        await SynchronisedAsync();
        var offset = _session.Clock.ModelAt(_headsetClock.Now).OffsetAt(_headsetClock.Now);

        foreach (var number in new[] { "1", "999999", "-1", "" })
            _rosbridge.Send(RosbridgeWriter.TimeResponse(RosTopics.GetTime, "nowpose time " + number, ControlTime.FromSeconds(5), RosTimeForm.Sec));
        await Soon.BecomesAsync(() => _session.SyncFaults[SyncExchangeFault.WrongSequence] >= 4, "counted");

        // The answers contain a time that differs by decades.
        Assert.That(
            (_session.Clock.ModelAt(_headsetClock.Now).OffsetAt(_headsetClock.Now) - offset).Duration(), Is.LessThan(ProtocolLimits.SyncReplyTimeout));
        Assert.That(_session.Clock.Steps, Is.Zero);
    }

    [TestCase(RosFlavour.Ros1)]
    [TestCase(RosFlavour.Ros2)]
    public async Task Status_RosapiMissing_SuggestsStartingRosapiAndRecovers(RosFlavour flavour)
    {
        Start(flavour, hasRosapi: false);

        await Soon.BecomesAsync(() => _session.SyncLink.State == LinkState.Waiting && _session.SampleLink.State == LinkState.Connected, "refused");
        Assert.That(_session.SyncLink.Detail, Does.Contain(ConnectionMessages.RosCallFailed("Service /rosapi/get_time does not exist")));

        _graph.HasRosapi = true;
        await SynchronisedAsync();
        Assert.That(_session.SyncLink.State, Is.EqualTo(LinkState.Connected));
        Assert.That(_rosbridge.Connections, Is.EqualTo(1), "the joint positions' connection stays");
    }

    [Test]
    public async Task Session_RosbridgeInANamespace_SynchronisesWithItsOwnRosapi()
    {
        Start(RosFlavour.Ros2, rosNamespace: "/robot1");

        await SynchronisedAsync();

        var error = ClockError(out var model);
        Assert.That(error.Duration(), Is.LessThanOrEqualTo(model.ErrorBound));
    }

    [Test]
    public async Task Status_TimeIsZero_NamesTheSimulatedClock()
    {
        _control = new StopwatchControlClock(default) { Resolution = TimeSpan.FromDays(1) };
        _graph = new RosGraph(RosFlavour.Ros2, _control);
        _rosbridge = new RosbridgeDouble(_graph);
        _session = NewSession(_rosbridge.Port);

        _session.Connect();

        await Soon.BecomesAsync(() => _session.SyncLink.Detail.Contains(ConnectionMessages.RosTimeZero), "the link states the reason");
    }

    [Test]
    public async Task Exchanges_NoAnswer_EndsTheConnectionAndReconnects()
    {
        Start(RosFlavour.Ros2);
        _rosbridge.IsMute = true;

        await Soon.BecomesAsync(() =>
            _session.SyncLink.Detail.Contains(ConnectionMessages.NoAnswer("/rosapi/get_time", 2)), "the link states the reason");

        _rosbridge.IsMute = false;
        await SynchronisedAsync();
        Assert.That(_rosbridge.Connections, Is.GreaterThan(1));
    }
}
