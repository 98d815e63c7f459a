using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Cell.CellTexts;

namespace Nowpose.Headless.Tests.Gateway.Cell;

public class SignalTopicTests
{
    GatewayServer _gateway;
    RawRosbridgeClient _source, _headset;

    [SetUp]
    public async Task StartAsync()
    {
        _gateway = await Gateways.StartAsync();
        _source = await RawRosbridgeClient.ConnectAsync(_gateway);
        _headset = await RawRosbridgeClient.ConnectAsync(_gateway);
    }

    [TearDown]
    public async Task StopAsync()
    {
        _source.Dispose();
        _headset.Dispose();
        await _gateway.DisposeAsync();
    }

    async Task SendAsync(string text)
    {
        await _source.SendAsync(text);
        await _source.RoundTripAsync();
    }

    [TestCase("nowpose_msgs/Signals", "\"secs\":5000")]
    [TestCase("nowpose_msgs/msg/Signals", "\"sec\":5000")]
    [TestCase(null, "\"sec\":5000")]
    public async Task Publish_Signals_ReachEachSubscriberInTheTimeFormatOfItsType(string type, string expected)
    {
        await _headset.SubscribeAsync(RosTopics.Signals, type);

        await SendAsync(SignalsText(("grip", 1), ("belt.speed", -0.25)));

        var text = await _headset.ReceiveTextAsync();
        Assert.That(text, Does.Contain(expected));
        Assert.That(RosbridgeReader.TryRead(text, out var message, out _), Is.True);
        Assert.That(message.Signals.Text(), Is.EqualTo("grip=1 belt.speed=-0.25"));
    }

    [Test]
    public async Task Subscribe_AfterPublication_ReceivesTheNewestValueOfEachSignalWithItsTimeStamp()
    {
        await SendAsync(SignalsAt(ControlTime.FromSeconds(4000), ("grip", 1), ("lamp", 1), ("door", 0)));
        await SendAsync(SignalsAt(ControlTime.FromSeconds(4001), ("grip", 0)));
        await SendAsync(SignalsAt(ControlTime.FromSeconds(4002), ("lamp", 2)));

        await _headset.SendAsync(RosbridgeWriter.Subscribe(RosTopics.Signals, "nowpose_msgs/Signals"));

        var received = new List<(string, double)>();
        while (received.Count < 3)
        {
            var signals = (await _headset.ReceiveAsync()).Signals;
            received.Add((signals.Text(), signals.Stamp.SinceEpoch.TotalSeconds));
        }

        Assert.That(received, Is.EqualTo(new[] { ("door=0", 4000.0), ("grip=0", 4001.0), ("lamp=2", 4002.0) }));
        await _headset.RoundTripAsync();
        await SendAsync(SignalsText(("door", 1)));
        Assert.That((await _headset.ReceiveAsync()).Signals.Text(), Is.EqualTo("door=1"));
    }

    [Test]
    public async Task Subscribe_MoreSignalsThanTheQueueHolds_ReceivesAll()
    {
        for (var i = 0; i < 256; i++) await _source.SendAsync(SignalsAt(ControlTime.FromSeconds(4000 + i), ($"s{i}", i)));
        await _source.RoundTripAsync();

        await _headset.SendAsync("""{"op":"subscribe","topic":"/signals","queue_length":1}""");

        for (var i = 0; i < 256; i++) Assert.That((await _headset.ReceiveAsync()).Signals.Text(), Is.EqualTo($"s{i}={i}"));
        await _headset.RoundTripAsync();
        Assert.That(_gateway.Drops.Total, Is.Zero);
    }

    [Test]
    public async Task Subscribe_AfterTheSourceEnded_ReceivesNoSignal()
    {
        await SendAsync(SignalsText(("grip", 1)));
        _source.Dispose();
        await Soon.BecomesAsync(() => _gateway.WebSocketConnections.Open == 1, "the source has disconnected");

        await _headset.SubscribeAsync(RosTopics.Signals);

        await _headset.RoundTripAsync();
    }

    [Test]
    public async Task SignalStatus_AdapterReportsAFault_ContainsTheSignalUntilItIsLiveAgain()
    {
        await _headset.SendAsync(RosbridgeWriter.Subscribe(RosTopics.SignalStatus, "diagnostic_msgs/DiagnosticArray"));
        Assert.That((await _headset.ReceiveAsync()).SignalStatus.Joints, Is.Empty);
        Task ReportAsync(string state) => SendAsync(RosbridgeWriter.Publish(RosTopics.Diagnostics, new DiagnosticsMessage(
            Gateways.Start, "plant/cell", [KeyValuePair.Create("state", "connected"), KeyValuePair.Create("signal/grip", state)], 2, "plant/cell"), RosTimeForm.Sec));

        await ReportAsync("fault 1700000000.000 the server no longer has this node");

        var fault = (await _headset.ReceiveAsync()).SignalStatus.Joints.Single();
        Assert.That((fault.Joint, fault.State, fault.Reason), Is.EqualTo(("grip", JointDataState.Fault, "the server no longer has this node")));
        await ReportAsync("fault 1700000000.000 the server no longer has this node");
        await ReportAsync("live 1700000001.000");
        Assert.That((await _headset.ReceiveAsync()).SignalStatus.Joints, Is.Empty, "the repeated report is not published again");
    }

    [Test]
    public async Task SignalStatus_AdapterReportsALiveSignalOfAnotherSource_DoesNotContainTheSignal()
    {
        await SendAsync(SignalsText(("grip", 1)));
        await _headset.SendAsync(RosbridgeWriter.Subscribe(RosTopics.SignalStatus, "diagnostic_msgs/DiagnosticArray"));
        Assert.That((await _headset.ReceiveAsync()).SignalStatus.Joints, Is.Empty);
        using var adapter = await RawRosbridgeClient.ConnectAsync(_gateway);
        Task ReportAsync(string name) => adapter.SendAsync(RosbridgeWriter.Publish(RosTopics.Diagnostics, new DiagnosticsMessage(
            Gateways.Start, "plant/other", [KeyValuePair.Create("state", "connected"), KeyValuePair.Create("signal/" + name, "fault 1700000000.000 no connection")],
            2, "plant/other"), RosTimeForm.Sec));

        await ReportAsync("grip");
        await ReportAsync("lamp");

        Assert.That((await _headset.ReceiveAsync()).SignalStatus.Joints.Single().Joint, Is.EqualTo("lamp"));
    }

    [Test]
    public async Task SignalStatus_SourceEnded_ContainsItsSignalsUntilTheyHaveASourceAgain()
    {
        await _headset.SendAsync(RosbridgeWriter.Subscribe(RosTopics.SignalStatus, "diagnostic_msgs/DiagnosticArray"));
        Assert.That((await _headset.ReceiveAsync()).SignalStatus.Joints, Is.Empty);
        await SendAsync(SignalsText(("grip", 1), ("lamp", 1)));

        _source.Dispose();

        var ended = (await _headset.ReceiveAsync()).SignalStatus.Joints;
        Assert.That(ended.Select(one => one.Joint), Is.EquivalentTo(new[] { "grip", "lamp" }));
        Assert.That(ended[0].State, Is.EqualTo(JointDataState.Stale));
        Assert.That(ended[0].Reason, Is.EqualTo(EventTexts.SourceEnded("rosbridge 127.0.0.1")));
        Assert.That(ended[0].Since, Is.GreaterThanOrEqualTo(Gateways.Start));
        using var late = await RawRosbridgeClient.ConnectAsync(_gateway);
        await late.SendAsync(RosbridgeWriter.Subscribe(RosTopics.SignalStatus));
        Assert.That((await late.ReceiveAsync()).SignalStatus.Joints, Has.Count.EqualTo(2));
        await late.SendAsync(SignalsText(("grip", 1)));
        Assert.That((await late.ReceiveAsync()).SignalStatus.Joints.Single().Joint, Is.EqualTo("lamp"));
        Assert.That((await _headset.ReceiveAsync()).SignalStatus.Joints.Single().Joint, Is.EqualTo("lamp"));
    }

    [Test]
    public async Task SecondSource_ForASignal_IsRefusedUntilTheFirstEnds()
    {
        using var second = await RawRosbridgeClient.ConnectAsync(_gateway);
        await SendAsync(SignalsText(("grip", 1)));

        await second.SendAsync(SignalsText(("lamp", 1), ("grip", 0)));

        await second.ExpectErrorAsync(
            $"{CellMessageFaults.Of("signal grip", DropReason.SignalTaken)}, rosbridge 127.0.0.1 ({DropReason.SignalTaken})");
        Assert.That(_gateway.Drops[DropReason.SignalTaken], Is.EqualTo(1));
        await _headset.SendAsync(RosbridgeWriter.Subscribe(RosTopics.Signals));
        var values = new[] { (await _headset.ReceiveAsync()).Signals.Text(), (await _headset.ReceiveAsync()).Signals.Text() };
        Assert.That(values, Is.EqualTo(new[] { "grip=1", "lamp=1" }), "the signal without another source is published");
        _source.Dispose();
        await Soon.BecomesAsync(() => _gateway.WebSocketConnections.Open == 2, "the first has disconnected");
        await second.SendAsync(SignalsText(("lamp", 1), ("grip", 0)));
        await second.RoundTripAsync();
    }

    [Test]
    public async Task Publish_SignalsFromSeveralSources_AreAcceptedUpTo256()
    {
        using var other = await RawRosbridgeClient.ConnectAsync(_gateway);
        await other.SendAsync(SignalsText([.. Enumerable.Range(0, 255).Select(i => ("a" + i, 0.0))]));
        await other.RoundTripAsync();
        await _headset.SendAsync(RosbridgeWriter.Subscribe(RosTopics.Signals));
        Assert.That((await _headset.ReceiveAsync()).Signals.Count, Is.EqualTo(255));

        await _source.SendAsync(SignalsText(("b", 1), ("c", 2), ("d", 3)));

        await _source.ExpectErrorAsync($"{CellMessageFaults.Of("signal c", DropReason.TooManySignals)} (1 more) ({DropReason.TooManySignals})");
        Assert.That((await _headset.ReceiveAsync()).Signals.Text(), Is.EqualTo("b=1"));
        Assert.That(_gateway.Drops[DropReason.TooManySignals], Is.EqualTo(2));
    }

    [TestCase("\"value\":[NaN]", DropReason.NotFinite)]
    [TestCase("\"value\":[1.0,2.0]", DropReason.LengthMismatch)]
    [TestCase("\"value\":[true]", DropReason.WrongType)]
    public async Task Publish_InvalidSignals_AreDroppedWithTheReason(string value, object reason)
    {
        await _source.SendAsync(SignalsText(("grip", 1)).Replace("\"value\":[1.0]", value));

        await _source.ExpectErrorAsync($"({reason})");
        Assert.That(_gateway.Drops[(DropReason)reason], Is.EqualTo(1));
    }

    [TestCase("[1.0,NaN,3.0]", "NaN")]
    [TestCase("[1.0,null,3.0]", "null")]
    public async Task Publish_OneInvalidSignal_OmitsOnlyThisSignal(string values, string invalid)
    {
        await _headset.SubscribeAsync(RosTopics.Signals);

        await _source.SendAsync(SignalsText(("a", 1), ("b", 2), ("c", 3)).Replace("[1.0,2.0,3.0]", values));

        await _source.ExpectErrorAsync($"signal b {CellMessageFaults.Has("value", invalid)} (NotFinite)");
        Assert.That((await _headset.ReceiveAsync()).Signals.Text(), Is.EqualTo("a=1 c=3"));
        Assert.That(_gateway.Drops.Total, Is.EqualTo(1));
    }

    // The names look like dates, which a JSON library may convert.
    [Test]
    public async Task Publish_SameSignalTwice_OmitsBoth()
    {
        await _headset.SubscribeAsync(RosTopics.Signals);

        await _source.SendAsync(SignalsText(("2024-01-01T00:00:00", 1), ("a", 2), ("2024-01-01T00:00:00", 3)));

        await _source.ExpectErrorAsync($"signal 2024-01-01T00:00:00 {CellMessageFaults.Twice} ({DropReason.DuplicateName})");
        Assert.That((await _headset.ReceiveAsync()).Signals.Text(), Is.EqualTo("a=2"));
    }

    [Test]
    public void TryRead_LongHeaderAndManyInvalidSignals_NeedsLittleMemory()
    {
        var text = SignalsText([.. Enumerable.Range(0, 256).Select(i => ("s" + i, 1.0))]).Replace("1.0", "null")
            .Replace("\"header\":{", "\"header\":{\"unknown\":[" + string.Join(',', Enumerable.Repeat(0, 25_000)) + "],");
        var utf8 = System.Text.Encoding.UTF8.GetBytes(text);
        var leftOut = new List<Nowpose.Gateway.Hub.LeftOut>();
        new RosbridgeReader().TryRead(utf8, out var message, out _);
        var before = GC.GetAllocatedBytesForCurrentThread();

        var isAny = new Nowpose.Gateway.Rosbridge.PartialCellMessage().TryRead(utf8, message, leftOut);

        Assert.That((isAny, leftOut.Count), Is.EqualTo((false, 256)));
        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.LessThan(20_000_000));
    }

    [Test]
    public async Task SignalStatus_NewestValueRefused_ContainsTheSignalUntilItsNextValidValue()
    {
        await SendAsync(SignalsText(("grip", 1)));
        await _headset.SendAsync(RosbridgeWriter.Subscribe(RosTopics.SignalStatus));
        Assert.That((await _headset.ReceiveAsync()).SignalStatus.Joints, Is.Empty);

        await _source.SendAsync(SignalsText(("grip", 0)).Replace("[0.0]", "[NaN]"));
        await _source.ExpectErrorAsync("NotFinite");

        var refused = (await _headset.ReceiveAsync()).SignalStatus.Joints.Single();
        Assert.That((refused.Joint, refused.State), Is.EqualTo(("grip", JointDataState.Refused)));
        Assert.That(refused.Reason, Is.EqualTo("signal grip " + CellMessageFaults.Has("value", "NaN")));
        await SendAsync(SignalsText(("grip", 0)));
        Assert.That((await _headset.ReceiveAsync()).SignalStatus.Joints, Is.Empty);
    }

    [Test]
    public async Task Publish_TimeStampInTheFuture_IsDropped()
    {
        await _source.SendAsync(SignalsAt(ControlTime.FromSeconds(5100), ("grip", 1)));

        await _source.ExpectErrorAsync(DropMessages.Of(DropReason.StampInFuture));
        Assert.That(_gateway.Drops[DropReason.StampInFuture], Is.EqualTo(1));
    }

    // A signal may change only once in hours, so a slow reader must not lose its newest value.
    [Test]
    public async Task Reader_Slow_ReceivesTheNewestValueOfEachSignal()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { PongTimeout = TimeSpan.FromMinutes(1) });
        using var slow = await RawRosbridgeClient.ConnectAsync(gateway, options => options.SetBuffer(1024, 1024));
        await slow.SubscribeAsync(RosTopics.Signals);
        using var source = gateway.Hub.OpenSource();

        // After one change of grip, other signals change until messages are lost.
        var sent = 0;
        Publish("grip", 1);
        while (gateway.Drops[DropReason.SlowReader] < 100) Publish($"s{++sent % 100}", sent);
        Publish("last", 1);

        var values = new Dictionary<string, double>();
        while (!values.ContainsKey("last"))
        {
            var signals = (await slow.ReceiveAsync()).Signals;
            for (var i = 0; i < signals.Count; i++)
            {
                Assert.That(signals[i].Value, Is.GreaterThanOrEqualTo(values.GetValueOrDefault(signals[i].Name)), "no older value follows");
                values[signals[i].Name] = signals[i].Value;
            }
        }

        Assert.That(values["grip"], Is.EqualTo(1));
        for (var i = 0; i < 100; i++) Assert.That(values[$"s{(sent - i) % 100}"], Is.EqualTo(sent - i));

        void Publish(string name, double value) => Assert.That(
            source.Publish(new Nowpose.Protocol.Cell.SignalsMessage(Gateways.Start, new Nowpose.Protocol.Cell.SignalValue(name, value)), []), Is.True);
    }
}
