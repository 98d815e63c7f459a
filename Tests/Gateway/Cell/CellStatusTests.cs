using System.Text.Json;
using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Plants;
using Nowpose.Messages;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Cell.CellTexts;

namespace Nowpose.Headless.Tests.Gateway.Cell;

/// <summary>Tests the state and the metrics of a gateway with frames, signals and robots in namespaces.</summary>
public class CellStatusTests
{
    GatewayServer _gateway;
    RawRosbridgeClient _source;

    [SetUp]
    public async Task StartAsync()
    {
        _gateway = await Gateways.StartAsync();
        _source = await RawRosbridgeClient.ConnectAsync(_gateway);
    }

    [TearDown]
    public async Task StopAsync()
    {
        _source.Dispose();
        await _gateway.DisposeAsync();
    }

    async Task<string> GetAsync(string path)
    {
        using var http = new HttpClient();
        return await http.GetStringAsync(new UriBuilder(_gateway.WebSocketUri()) { Scheme = "http", Path = path }.Uri).Bounded();
    }

    async Task<JsonElement> StateAsync() => JsonDocument.Parse(await GetAsync("/operations/state")).RootElement;

    static string State(string robot, ControlTime stamp, double position = 1) => RosbridgeWriter.Publish(
        RobotTopic.NameOf(robot, RosTopics.JointStates), new JointStateMessage(stamp, ["a"], [position]), RosTimeForm.Sec);

    [Test]
    public async Task State_TwoRobots_ListsTheJointsOfEach()
    {
        await _source.SendAsync(State("arm1", Gateways.Start));
        await _source.SendAsync(State("arm2", Gateways.Start));
        await _source.SendAsync(State("", Gateways.Start));
        await _source.RoundTripAsync();

        var state = await StateAsync();

        var joints = state.GetProperty("joints").EnumerateArray().Select(joint => joint.GetProperty("name").GetString());
        Assert.That(joints, Is.EqualTo(new[] { "a", "arm1/a", "arm2/a" }));
        var messages = state.GetProperty("messages");
        Assert.That(messages.GetProperty("/joint_states").GetInt64(), Is.EqualTo(1));
        Assert.That(messages.GetProperty("/*/joint_states").GetInt64(), Is.EqualTo(2));
    }

    [TestCase(false, "ok")]
    [TestCase(true, "warning")]
    public async Task State_ObjectsWithoutJoints_IsOkUnlessARobotIsDescribed(bool hasRobot, string level)
    {
        if (hasRobot) await _source.SendAsync(RosbridgeWriter.Publish(RosTopics.RobotDescription, new StringMessage(RobotFiles.LoadText("youbot"))));
        await _source.SendAsync(Tf(Frame("box")));
        await _source.SendAsync(SignalsText(("belt", 1)));
        await _source.RoundTripAsync();

        // The gateway reads the description in the background.
        await Soon.BecomesAsync(() => StateAsync().GetAwaiter().GetResult().GetProperty("status").GetProperty("level").GetString() == level, level);
    }

    [Test]
    public async Task State_DescribedRobotsReplacedByUndescribedRobots_IsOkWithObjectsOnly()
    {
        var description = new StringMessage("<robot><link name=\"a\"/></robot>");
        for (var i = 0; i < ProtocolLimits.Robots; i++) await _source.SendAsync(RosbridgeWriter.Publish($"/old{i}/robot_description", description));
        await _source.RoundTripAsync();
        _source.Dispose();
        await Soon.BecomesAsync(() => _gateway.WebSocketConnections.Open == 0, "the source has disconnected");
        using var twin = await RawRosbridgeClient.ConnectAsync(_gateway);
        await twin.SendAsync(Tf(Frame("box")));
        await twin.RoundTripAsync();
        Assert.That((await StateAsync()).GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("warning"));

        for (var i = 0; i < ProtocolLimits.Robots; i++) await twin.SendAsync(RosbridgeWriter.Advertise($"/new{i}/joint_states", null));
        await twin.SendAsync(Tf(Frame("box", stamp: Gateways.Start + TimeSpan.FromTicks(10))));
        await twin.RoundTripAsync();

        Assert.That((await StateAsync()).GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("ok"));
    }

    [Test]
    public async Task State_InvalidSampleOfARobot_RefusesTheJointsOfThatRobotOnly()
    {
        using var other = await RawRosbridgeClient.ConnectAsync(_gateway);
        await _source.SendAsync(State("arm1", Gateways.Start));
        await _source.RoundTripAsync();

        await other.SendAsync(State("arm2", Gateways.Start).Replace("[1.0]", "[null]"));
        await other.ExpectErrorAsync("NotFinite");

        var states = (await StateAsync()).GetProperty("joints").EnumerateArray()
            .ToDictionary(joint => joint.GetProperty("name").GetString(), joint => joint.GetProperty("state").GetString());
        Assert.That(states["arm1/a"], Is.EqualTo("live"));
        Assert.That(states["arm2/a"], Is.EqualTo("refused"));
    }

    [Test]
    public async Task State_OnlyInvalidFramesAndSignals_AreRefusedWithTheReason()
    {
        await _source.SendAsync(Tf(Frame("box")).Replace("\"w\":1.0", "\"w\":2.0"));
        await _source.ExpectErrorAsync("NotUnitQuaternion");
        await _source.SendAsync(SignalsText(("grip", 1)).Replace("[1.0]", "[null]"));
        await _source.ExpectErrorAsync("NotFinite");

        var state = await StateAsync();

        var box = state.GetProperty("frames").EnumerateArray().Single();
        var grip = state.GetProperty("signals").EnumerateArray().Single();
        Assert.That(new[] { box, grip }.Select(one => one.GetProperty("state").GetString()), Is.All.EqualTo("refused"));
        Assert.That(box.GetProperty("reason").GetString(), Is.EqualTo(
            RequestMessages.Dropped(
                "rosbridge 127.0.0.1", "frame box " + FrameMessages.Norm(2, "0.001"), DropReason.NotUnitQuaternion)));
        Assert.That(grip.TryGetProperty("value", out _), Is.False, "no valid value is known");
        Assert.That(state.GetProperty("status").GetProperty("text").GetString(), Does.Contain("box (rosbridge 127.0.0.1) " + EventTexts.IsRefused));
    }

    [TestCase("[]")]
    [TestCase("[0.0,1.0]")]
    public async Task State_SignalWithoutAValueForItsName_IsRefusedWithTheReason(string values)
    {
        await _source.SendAsync(SignalsText(("grip", 1)));

        await _source.SendAsync(SignalsText(("grip", 0)).Replace("[0.0]", values));
        await _source.ExpectErrorAsync("(LengthMismatch)");

        var grip = (await StateAsync()).GetProperty("signals").EnumerateArray().Single();
        Assert.That((grip.GetProperty("state").GetString(), grip.GetProperty("value").GetDouble()), Is.EqualTo(("refused", 1.0)));
        Assert.That(grip.GetProperty("reason").GetString(), Does.Contain("signal grip: " + DropMessages.Of(DropReason.LengthMismatch)));
        Assert.That(_gateway.Drops.Total, Is.EqualTo(1));
    }

    [Test]
    public async Task State_SecondSourceOfAFrameOrSignal_IsAnEventAndKeepsThemLive()
    {
        using var second = await RawRosbridgeClient.ConnectAsync(_gateway);
        await _source.SendAsync(Tf(Frame("box")));
        await _source.SendAsync(SignalsText(("grip", 1)));
        await _source.RoundTripAsync();

        await second.SendAsync(Tf(Frame("box")));
        await second.ExpectErrorAsync("FrameTaken");
        await second.SendAsync(SignalsText(("grip", 1)).Replace("[1.0]", "[null]"));
        await second.ExpectErrorAsync("NotFinite");

        var state = await StateAsync();
        Assert.That(state.GetProperty("frames").EnumerateArray().Single().GetProperty("state").GetString(), Is.EqualTo("live"));
        Assert.That(state.GetProperty("signals").EnumerateArray().Single().GetProperty("state").GetString(), Is.EqualTo("live"));
        await Soon.BecomesAsync(() => Events().Contains(EventTexts.SourceRefused("rosbridge 127.0.0.1", "frame box"))
            && Events().Contains(EventTexts.SourceRefused("rosbridge 127.0.0.1", "signal grip")), "both are events");

        string Events() => GetAsync("/operations/state").GetAwaiter().GetResult();
    }

    [Test]
    public async Task Metrics_FramesAndSignals_AreCountedByTopicAndReason()
    {
        await _source.SendAsync(Tf(Frame("a")));
        await _source.SendAsync(TfStatic(Frame("b", "a")));
        await _source.SendAsync(SignalsText(("grip", 1)));
        await _source.RoundTripAsync();
        await _source.SendAsync(Tf(Frame("a", "b")));
        await _source.ExpectErrorAsync("FrameCycle");

        var metrics = await GetAsync("/metrics");

        foreach (var topic in new[] { "/tf", "/tf_static", "/signals" })
            Assert.That(metrics, Does.Contain($"nowpose_messages_total{{topic=\"{topic}\"}} 1\n"));
        Assert.That(metrics, Does.Contain("nowpose_drops_total{reason=\"FrameCycle\"} 1\n"));
        Assert.That(metrics, Does.Contain("nowpose_messages_total{topic=\"/*/robot_description\"} 0\n"));
    }

    [TestCase("frames", true)]
    [TestCase("signals", true)]
    [TestCase("stationary frames", false)]
    public async Task TimeStamps_InTheFuture_IndicateAWrongClockExceptOnStationaryFrames(string kind, bool expected)
    {
        var stamp = Gateways.Start + TimeSpan.FromMinutes(10);
        var text = kind == "frames" ? Tf(Frame("a", stamp: stamp)) : kind == "signals" ? SignalsAt(stamp, ("grip", 1)) : TfStatic(Frame("a", stamp: stamp));

        for (var i = 0; i < 10; i++)
        {
            await _source.SendAsync(text);
            await _source.ExpectErrorAsync("StampInFuture");
        }

        _gateway.Clock.Stamps.Look(_ => { });
        Assert.That(_gateway.Clock.Stamps.IsContradicted, Is.EqualTo(expected));
    }

    [Test]
    public async Task TimeStamps_OnFramesOfAnotherSource_DoNotIndicateAWrongClock()
    {
        using var second = await RawRosbridgeClient.ConnectAsync(_gateway);
        await _source.SendAsync(Tf(Frame("a")));
        await _source.RoundTripAsync();

        for (var i = 0; i < 10; i++)
        {
            await second.SendAsync(Tf(Frame("a", stamp: Gateways.Start + TimeSpan.FromMinutes(10))));
            await second.ExpectErrorAsync("StampInFuture");
        }

        _gateway.Clock.Stamps.Look(_ => { });
        Assert.That(_gateway.Clock.Stamps.IsContradicted, Is.False);
    }
}
