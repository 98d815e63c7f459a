using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Status.Events;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Cell.CellTexts;

namespace Nowpose.Headless.Tests.Gateway.Status.Faults;

/// <summary>Tests how state, metrics and event list report frames and signals without current data.</summary>
public class CellFaultTests
{
    MonitoredGateway _gateway;

    [SetUp]
    public async Task StartAsync()
    {
        _gateway = new MonitoredGateway();
        await _gateway.StartAsync();
        // Ends the time in which a condition that is normal at startup causes no event.
        _gateway.Time.Advance(EventList.StartGrace);
    }

    [TearDown]
    public Task Close() => _gateway.DisposeAsync().AsTask();

    void Publish(params FrameTransform[] frames) => _gateway.Source.Publish(new TransformsMessage(frames), isStationary: false, []);

    async Task<(string Level, string Text)> StatusAsync()
    {
        var status = (await _gateway.StateAsync()).GetProperty("status");
        return (status.GetProperty("level").GetString(), status.GetProperty("text").GetString());
    }

    async Task<(string State, string Since)> FrameAsync(string name)
    {
        var frame = (await _gateway.StateAsync()).GetProperty("frames").EnumerateArray().Single(one => one.GetProperty("name").GetString() == name);
        return (frame.GetProperty("state").GetString(), frame.TryGetProperty("since_utc", out var since) ? since.GetString() : null);
    }

    [Test]
    public async Task Frame_ParentMissing_IsAnOrphanUntilTheParentAppears()
    {
        Publish(Frame("orph", "nowhere"));

        Assert.That(await FrameAsync("orph"), Is.EqualTo(("orphan", "2026-11-20T12:00:03.000Z")));
        Assert.That(await StatusAsync(), Is.EqualTo(("warning", "1 of 1 object or signal is not current: orph (orphan)")));
        Assert.That((await _gateway.GetAsync("/metrics")).Text, Does.Contain("nowpose_frame_state{frame=\"orph\",source=\"gateway\",state=\"orphan\"} 1\n"));

        _gateway.Time.Advance(TimeSpan.FromSeconds(1));
        Publish(Frame("orph", "nowhere"));

        await _gateway.BeginsAsync("frame", "orph (gateway)");
        var expected = $"frame orph (gateway) {EventTexts.IsOrphan}: {CellReasons.ParentMissing("nowhere")}. {EventRemedies.Parent}";
        Assert.That(await StatusAsync(), Is.EqualTo(("warning", expected)));

        _gateway.Time.Correct(TimeSpan.FromSeconds(-1.5));
        Publish(Frame("orph", "nowhere"));

        Assert.That(await StatusAsync(), Is.EqualTo(("warning", expected)), "the system clock was set back");

        Publish(Frame("nowhere"));

        Assert.That(await FrameAsync("orph"), Is.EqualTo(("live", (string)null)));
        await _gateway.EndsAsync("frame", "orph (gateway)");
        Assert.That((await StatusAsync()).Level, Is.EqualTo("ok"));
    }

    [Test]
    public async Task Frame_SourceOfItsParentEnds_IsAnOrphan()
    {
        using (var other = _gateway.Server.Hub.OpenSource())
        {
            other.Publish(new TransformsMessage([Frame("belt")]), isStationary: false, []);
            Publish(Frame("box", "belt"));
            Assert.That((await FrameAsync("box")).State, Is.EqualTo("live"));
        }

        Assert.That((await FrameAsync("box")).State, Is.EqualTo("orphan"));
    }

    // The event is that of the belt. The boxes and the lid name the belt, or the box above the lid, as the reason for their state.
    [TestCase("world", true)]
    [TestCase("nowhere", false)]
    [TestCase("nowhere", true)]
    public async Task Frame_ParentHasAnEventOfItsOwn_CausesNoSecondEvent(string parent, bool isEnded)
    {
        var feeder = _gateway.Server.Hub.OpenSource();
        feeder.Name = "feeder";
        for (var i = 0; i < 8; i++)
        {
            var stamp = Gateways.Start + TimeSpan.FromSeconds(0.5 * i);
            if (i == 2 && isEnded) feeder.Dispose();
            if (i < 2 || !isEnded) feeder.Publish(new TransformsMessage([Frame("belt", parent, stamp: stamp)]), isStationary: false, []);
            Publish(Frame("box1", "belt", stamp: stamp), Frame("box2", "belt", stamp: stamp), Frame("lid", "box1", stamp: stamp));
            await _gateway.StateAsync();
            _gateway.Time.Advance(TimeSpan.FromSeconds(0.5));
        }

        Publish(Frame("box1", "belt"), Frame("box2", "belt"), Frame("lid", "box1"));
        await _gateway.BeginsAsync("frame", "belt (feeder)");

        foreach (var child in new[] { "box1", "box2", "lid" })
        {
            Assert.That((await FrameAsync(child)).State, Is.EqualTo("orphan"));
            Assert.That((await _gateway.EventAsync("frame", child + " (gateway)")).ValueKind, Is.EqualTo(System.Text.Json.JsonValueKind.Undefined), child);
        }
    }

    [Test]
    public async Task Frame_PosesStop_IsAnEventUntilTheNextPose()
    {
        Publish(Frame("box"), Frame("lid"));
        _gateway.Time.Advance(TimeSpan.FromSeconds(0.9));
        Publish(Frame("lid", stamp: Gateways.Start + TimeSpan.FromSeconds(0.9)));
        _gateway.Time.Advance(TimeSpan.FromSeconds(0.3));

        await _gateway.BeginsAsync("frame", "box (gateway)");
        var one = await _gateway.EventAsync("frame", "box (gateway)");
        Assert.That(one.GetProperty("what").GetString(), Is.EqualTo(EventTexts.Is("stale")));
        Assert.That(one.GetProperty("since_utc").GetString(), Is.EqualTo("2026-11-20T12:00:03.000Z"));
        var expected = $"frame box (gateway) is stale: {CellReasons.PosesStopped}. {EventRemedies.Source}";
        Assert.That(await StatusAsync(), Is.EqualTo(("warning", expected)));

        Publish(Frame("box", stamp: Gateways.Start + TimeSpan.FromSeconds(1.2)));

        await _gateway.EndsAsync("frame", "box (gateway)");
        Assert.That((await StatusAsync()).Level, Is.EqualTo("ok"));
    }

    [Test]
    public async Task Frame_AtRestByItsAdapter_IsNoEvent()
    {
        _gateway.Source.Name = "cell";
        Publish(Frame("box"), Frame("lid"));
        // The gateway updates the event list while the test runs, so it must know the rest before the frames are late.
        _gateway.Report("adapter/cell", ("state", "connected"), ("frame/box", $"rest {_gateway.Since()} assumed at rest"));
        _gateway.Time.Advance(TimeSpan.FromSeconds(2));

        await _gateway.BeginsAsync("frame", "lid (cell)");
        Assert.That((await _gateway.EventAsync("frame", "box (cell)")).ValueKind, Is.EqualTo(System.Text.Json.JsonValueKind.Undefined));
    }

    [Test]
    public async Task Signal_SourceEnds_IsAnEventUntilAnotherSourcePublishes()
    {
        void Send(HubSource source) => source.Publish(new SignalsMessage(Gateways.Start, new SignalValue("grip", 1)), []);
        using (var first = _gateway.Server.Hub.OpenSource())
        {
            first.Name = "plc";
            Send(first);
        }

        await _gateway.BeginsAsync("signal", "grip (plc)");
        var expected = $"signal grip (plc) {EventTexts.HasNoSource}: {EventTexts.SourceEnded("plc")}. {EventRemedies.Source}";
        Assert.That(await StatusAsync(), Is.EqualTo(("warning", expected)));
        Assert.That((await _gateway.GetAsync("/metrics")).Text, Does.Contain("nowpose_signal_state{signal=\"grip\",source=\"plc\",state=\"ended\"} 1\n"));

        Send(_gateway.Source);

        await _gateway.EndsAsync("signal", "grip (plc)");
        Assert.That((await StatusAsync()).Level, Is.EqualTo("ok"));
    }

    [Test]
    public async Task Signal_AdapterStopsReporting_IsStaleUntilItsConnectionEnds()
    {
        HubMessage list = null;
        _gateway.Server.Hub.Subscribe(RosTopics.SignalStatus, message => list = message);
        _gateway.Source.Name = "plc";
        _gateway.Source.Publish(new SignalsMessage(Gateways.Start, new SignalValue("grip", 1)), []);
        _gateway.Report("adapter/plc", ("state", "connected"), ("signal/grip", $"live {_gateway.Since()}"), ("signal/lamp", $"missing {_gateway.Since()} no value"));
        string Listed() => string.Join(", ", ((DiagnosticsMessage)list.Content).Values.Select(pair => pair.Key + " " + pair.Value.Split(' ')[0]));
        Assert.That(Listed(), Is.EqualTo("lamp missing"));

        _gateway.Time.Advance(TimeSpan.FromSeconds(2.5));

        await Soon.BecomesAsync(() => Listed() == "lamp missing, grip stale", "the list for headsets has the signal");
        Assert.That((await _gateway.GetAsync("/metrics")).Text, Does.Contain("nowpose_signal_state{signal=\"grip\",source=\"plc\",state=\"stale\"} 1\n"));

        _gateway.Source.Dispose();

        await Soon.BecomesAsync(() => Listed() == "grip stale", "the adapter no longer reports the lamp");
        await _gateway.BeginsAsync("signal", "grip (plc)");
    }

    [Test]
    public async Task Frame_ReportedAtRestWithoutAPose_IsReportedAsMissing()
    {
        _gateway.Report("adapter/cell", ("state", "connected"), ("frame/box", $"rest {_gateway.Since()} assumed at rest"));

        await _gateway.BeginsAsync("frame", "box (cell)");
        Assert.That((await _gateway.EventAsync("frame", "box (cell)")).GetProperty("reason").GetString(), Is.EqualTo(CellReasons.NoPoseAtRest));
    }

    // The client closes its connection in another way afterwards, so that only the withdrawal is a normal end.
    [TestCase(RosTopics.Signals, "box")]
    [TestCase(RosTopics.Tf, "grip")]
    [TestCase(RosTopics.JointStates, "box, grip")]
    public async Task Unadvertise_OneTopic_EndsNormallyOnlyOnThisTopic(string topic, string kept)
    {
        using (var client = await RawRosbridgeClient.ConnectAsync(_gateway.Server))
        {
            await client.SendAsync(RosbridgeWriter.Advertise(topic, null));
            await client.SendAsync(Tf(Frame("box")));
            await client.SendAsync(SignalsText(("grip", 1)));
            await client.SendAsync($$"""{"op":"unadvertise","topic":"{{topic}}"}""");
            await client.RoundTripAsync();
        }

        await Soon.BecomesAsync(() => _gateway.Server.WebSocketConnections.Open == 0, "the client has disconnected");
        _gateway.Time.Advance(JointBoard.ForgottenAfter + TimeSpan.FromSeconds(1));

        var state = await _gateway.StateAsync();
        var names = state.GetProperty("frames").EnumerateArray().Concat(state.GetProperty("signals").EnumerateArray()).Select(one => one.GetProperty("name").GetString());
        Assert.That(string.Join(", ", names), Is.EqualTo(kept));
    }

    // The client closes its connection in another way afterwards, so that only the withdrawal is a normal end.
    [Test]
    public async Task Unadvertise_OneOfTwoRobots_EndsOnlyThisRobotNormally()
    {
        using (var client = await RawRosbridgeClient.ConnectAsync(_gateway.Server))
        {
            foreach (var robot in new[] { "arm1", "arm2" })
            {
                var topic = $"/{robot}/joint_states";
                await client.SendAsync(RosbridgeWriter.Advertise(topic, null));
                await client.SendAsync(RosbridgeWriter.Publish(topic, Gateways.State(1, "a"), RosTimeForm.Sec));
            }

            await client.SendAsync("{\"op\":\"unadvertise\",\"topic\":\"/arm1/joint_states\"}");
            await client.RoundTripAsync();
        }

        await Soon.BecomesAsync(() => _gateway.Server.WebSocketConnections.Open == 0, "the client has disconnected");
        _gateway.Time.Advance(JointBoard.ForgottenAfter + TimeSpan.FromSeconds(1));

        var joints = (await _gateway.StateAsync()).GetProperty("joints").EnumerateArray();
        Assert.That(joints.Select(joint => joint.GetProperty("name").GetString()), Is.EqualTo(new[] { "arm2/a" }));
    }

    // A stationary frame is sent only once, so the invalid pose of the second source may have been its new place.
    [TestCase("ends")]
    [TestCase("unadvertises")]
    public async Task StationaryFrame_InvalidPoseOfASecondSource_IsRefusedAfterTheFirstSourceHasLeft(string end)
    {
        using var first = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        await first.SendAsync(RosbridgeWriter.Advertise(RosTopics.TfStatic, RosTopics.TransformsType));
        await first.SendAsync(TfStatic(Frame("fixture")));
        await first.RoundTripAsync();
        using var second = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        await second.SendAsync(TfStatic(Frame("fixture", x: 123.5)).Replace("123.5", "null", StringComparison.Ordinal));
        await second.ExpectErrorAsync(nameof(DropReason.NotFinite));
        await _gateway.BeginsAsync("source", "rosbridge 127.0.0.1 of frame fixture");
        Assert.That((await FrameAsync("fixture")).State, Is.EqualTo("stationary"), "it still has the valid pose of its source");

        if (end == "ends") first.Dispose();
        else await first.SendAsync("{\"op\":\"unadvertise\",\"topic\":\"/tf_static\"}");

        await _gateway.BeginsAsync("frame", "fixture (rosbridge 127.0.0.1)");
        Assert.That((await FrameAsync("fixture")).State, Is.EqualTo("refused"));

        await second.SendAsync(TfStatic(Frame("fixture", x: 0.5)));
        await _gateway.EndsAsync("frame", "fixture (rosbridge 127.0.0.1)");
    }

    [Test]
    public async Task StationaryFrame_InvalidPoseOfASecondSourceThatHasCorrectedIt_IsNotRefused()
    {
        using var first = _gateway.Server.Hub.OpenSource();
        first.Publish(new TransformsMessage([Frame("fixture")]), isStationary: true, []);
        using var second = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        await second.SendAsync(TfStatic(Frame("fixture", x: 123.5)).Replace("123.5", "null", StringComparison.Ordinal));
        await second.ExpectErrorAsync(nameof(DropReason.NotFinite));
        await second.SendAsync(TfStatic(Frame("fixture", x: 0.5)));
        await second.ExpectErrorAsync(nameof(DropReason.FrameTaken));

        first.Dispose();

        Assert.That((await FrameAsync("fixture")).State, Is.EqualTo("stationary"));
    }
}
