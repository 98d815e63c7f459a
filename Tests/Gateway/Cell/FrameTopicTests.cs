using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Messages;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Cell.CellTexts;

namespace Nowpose.Headless.Tests.Gateway.Cell;

public class FrameTopicTests
{
    const string Urdf = "<robot name='r'><link name='base'/><link name='tool0'/><joint name='j' type='fixed'><parent link='base'/><child link='tool0'/></joint></robot>";

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

    async Task<string> NextFramesAsync() => (await _headset.ReceiveAsync()).Transforms.Text();

    // Sends a message, which the gateway must accept without a status.
    async Task SendAsync(string text)
    {
        await _source.SendAsync(text);
        await _source.RoundTripAsync();
    }

    [TestCase(RosTopics.Tf, "tf2_msgs/TFMessage", "\"secs\":5000")]
    [TestCase(RosTopics.Tf, "tf2_msgs/msg/TFMessage", "\"sec\":5000")]
    [TestCase(RosTopics.TfStatic, "tf2_msgs/TFMessage", "\"secs\":5000")]
    [TestCase(RosTopics.TfStatic, null, "\"sec\":5000")]
    public async Task Publish_Frames_ReachEachSubscriberInTheTimeFormatOfItsType(string topic, string type, string expected)
    {
        await _headset.SubscribeAsync(topic, type);
        await _source.SendAsync(RosbridgeWriter.Advertise(topic, "tf2_msgs/TFMessage"));

        await SendAsync(topic == RosTopics.Tf ? Tf(Frame("box", "belt", 0.5), Frame("belt")) : TfStatic(Frame("box", "belt", 0.5), Frame("belt")));

        var text = await _headset.ReceiveTextAsync();
        Assert.That(text, Does.Contain(expected).And.Contain("\"topic\":\"" + topic + "\""));
        Assert.That(RosbridgeReader.TryRead(text, out var message, out _), Is.True);
        Assert.That(message.Transforms.Text(), Is.EqualTo("box=0.5 belt=0"));
    }

    [TestCase("\"rotation\":{\"x\":0,\"y\":0,\"z\":0,\"w\":1.02}", DropReason.NotUnitQuaternion)]
    [TestCase("\"rotation\":{\"x\":0,\"y\":NaN,\"z\":0,\"w\":1}", DropReason.NotFinite)]
    [TestCase("\"rotation\":{\"x\":0,\"y\":0,\"z\":0}", DropReason.MissingField)]
    public async Task Publish_InvalidRotation_DropsTheFrameWithTheReason(string rotation, object reason)
    {
        await _headset.SubscribeAsync(RosTopics.Tf);

        await _source.SendAsync(Tf(Frame("box")).Replace("\"rotation\":{\"x\":0.0,\"y\":0.0,\"z\":0.0,\"w\":1.0}", rotation));

        await _source.ExpectErrorAsync($"({reason})");
        Assert.That(_gateway.Drops[(DropReason)reason], Is.EqualTo(1));
        await SendAsync(Tf(Frame("box", x: 2)));
        Assert.That(await NextFramesAsync(), Is.EqualTo("box=2"));
    }

    [Test]
    public async Task Publish_InvalidFrames_AreDroppedAndNamedInTheReason()
    {
        await _source.SendAsync(Tf(Frame("box", "box")));
        await _source.ExpectErrorAsync($"frame box {FrameMessages.IsOwnParent} (OwnParent)");
        await _source.SendAsync(Tf(Frame("box"), Frame("box")));
        await _source.ExpectErrorAsync($"frame box {FrameMessages.OccursTwice} (DuplicateName)");
        await _source.SendAsync(Tf(Frame("box", stamp: default(ControlTime))));
        await _source.ExpectErrorAsync($"frame box {CellMessageFaults.StampZero} (StampZero)");
        await _source.SendAsync(Tf(Frame("belt"), Frame("box", stamp: ControlTime.FromSeconds(5100))));
        await _source.ExpectErrorAsync($"frame box: {DropMessages.Of(DropReason.StampInFuture)} (StampInFuture)");
        await _source.SendAsync(TfStatic(Frame("box", stamp: ControlTime.FromSeconds(5100))));
        await _source.ExpectErrorAsync("(StampInFuture)");
        await _source.SendAsync(Tf(Frame("world", "map")));
        await _source.ExpectErrorAsync(
            $"{CellMessageFaults.Of(CellMessageFaults.Frame("world", "map"), DropReason.WorldAsChild)} (WorldAsChild)");

        await SendAsync(TfStatic(Frame("box", stamp: default(ControlTime))));
        Assert.That(_gateway.Drops.Total, Is.EqualTo(6));
    }

    static string Fault(string child, string parent, DropReason why) => CellMessageFaults.Of(CellMessageFaults.Frame(child, parent), why);

    static readonly string[][] InvalidFrames =
    [
        ["\"x\":2.0", "\"x\":NaN", $"frame b {FrameMessages.WrongField("transform.translation.x", "NaN", FrameMessages.FiniteNumber)} (NotFinite)"],
        ["\"x\":2.0", "\"x\":2e6", "(OutOfRange)"],
        [
            "\"child_frame_id\":\"b\"", "\"child_frame_id\":\"\"",
            $"frame {CellMessageFaults.NoName} {FrameMessages.NoField("child_frame_id")} (MissingField)",
        ],
        [
            "\"child_frame_id\":\"b\"", "\"child_frame_id\":\"b\",\"child_frame_id\":\"b\"",
            $"frame b: {DropMessages.Of(DropReason.DuplicateField)} (DuplicateField)",
        ],
    ];

    [TestCaseSource(nameof(InvalidFrames))]
    public async Task Publish_OneInvalidFrame_OmitsOnlyThisFrame(string valid, string invalid, string fault)
    {
        await _headset.SubscribeAsync(RosTopics.Tf);

        await _source.SendAsync(Tf(Frame("a", x: 1), Frame("b", x: 2), Frame("c", x: 3)).Replace(valid, invalid));

        await _source.ExpectErrorAsync(fault);
        Assert.That(await NextFramesAsync(), Is.EqualTo("a=1 c=3"));
        Assert.That(_gateway.Drops.Total, Is.EqualTo(1));
    }

    [Test]
    public async Task Publish_OneFrameInTheFutureOrTwice_OmitsOnlyThisFrame()
    {
        await _headset.SubscribeAsync(RosTopics.Tf);

        await _source.SendAsync(Tf(Frame("a", x: 1), Frame("b", x: 2, stamp: ControlTime.FromSeconds(5100))));

        await _source.ExpectErrorAsync("frame b: " + DropMessages.Of(DropReason.StampInFuture));
        Assert.That(await NextFramesAsync(), Is.EqualTo("a=1"));

        await _source.SendAsync(Tf(Frame("b", x: 1), Frame("a", x: 2), Frame("b", x: 3)));

        await _source.ExpectErrorAsync($"frame b {FrameMessages.OccursTwice} ({DropReason.DuplicateName})");
        Assert.That(await NextFramesAsync(), Is.EqualTo("a=2"), "neither of the poses of b is known to be right");
    }

    [Test]
    public async Task Publish_TooManyFramesWithAnInvalidOne_AreDropped()
    {
        await _headset.SubscribeAsync(RosTopics.Tf);
        var frames = Enumerable.Range(0, 257).Select(i => Frame("f" + i)).ToArray();

        await _source.SendAsync(Tf(frames).Replace("\"child_frame_id\":\"f9\"", "\"child_frame_id\":\"\""));

        await _source.ExpectErrorAsync("MissingField");
        await _headset.RoundTripAsync();
    }

    [Test]
    public async Task Publish_FrameThatClosesACycleAcrossTwoSources_IsOmitted()
    {
        using var other = await RawRosbridgeClient.ConnectAsync(_gateway);
        await other.SendAsync(TfStatic(Frame("a", "c")));
        await other.RoundTripAsync();
        await _headset.SubscribeAsync(RosTopics.Tf);

        await _source.SendAsync(Tf(Frame("b", "a", 1), Frame("c", "b", 2), Frame("d", "b", 3)));

        await _source.ExpectErrorAsync("publish /tf dropped: " + Fault("c", "b", DropReason.FrameCycle) + " (FrameCycle)");
        Assert.That(await NextFramesAsync(), Is.EqualTo("b=1 d=3"));
        Assert.That(_gateway.Drops[DropReason.FrameCycle], Is.EqualTo(1));
        await _source.RoundTripAsync();
    }

    [Test]
    public async Task Publish_ChainOf17Frames_OmitsTheDeepestFrame()
    {
        await _headset.SubscribeAsync(RosTopics.Tf);

        await _source.SendAsync(Tf([.. Enumerable.Range(1, 18).Select(i => Frame("f" + i, i == 1 ? "world" : $"f{i - 1}"))]));

        // f17 is too deep, so the gateway leaves it out. Then the parent of f18 is unknown and counts as a root.
        await _source.ExpectErrorAsync(Fault("f17", "f16", DropReason.FrameTooDeep) + " (FrameTooDeep)");
        Assert.That((await _headset.ReceiveAsync()).Transforms.Count, Is.EqualTo(17));
    }

    [Test]
    public async Task Publish_FramesFromSeveralSources_AreAcceptedUpTo256()
    {
        using var other = await RawRosbridgeClient.ConnectAsync(_gateway);
        await other.SendAsync(Tf([.. Enumerable.Range(0, 200).Select(i => Frame("a" + i))]));
        await other.RoundTripAsync();
        await _headset.SubscribeAsync(RosTopics.Tf);

        await _source.SendAsync(Tf([.. Enumerable.Range(0, 60).Select(i => Frame("b" + i))]));

        await _source.ExpectErrorAsync(Fault("b56", "world", DropReason.TooManyFrames) + " (3 more) (TooManyFrames)");
        Assert.That((await _headset.ReceiveAsync()).Transforms.Count, Is.EqualTo(56));
        Assert.That(_gateway.Drops[DropReason.TooManyFrames], Is.EqualTo(4), "each is counted");
    }

    [Test]
    public async Task Publish_FrameThatClosesACycleThroughADescribedRobot_IsOmitted()
    {
        await SendAsync(RosbridgeWriter.Publish("/arm1/robot_description", new StringMessage(Urdf)));
        await _gateway.Hub.Links.Read.Bounded();
        await SendAsync(Tf(Frame("box", "arm1/tool0")));

        await _source.SendAsync(Tf(Frame("arm1/base", "box")));

        await _source.ExpectErrorAsync("FrameCycle");
        await SendAsync(Tf(Frame("arm1/base", "world")));
    }

    [Test]
    public async Task Describe_RobotThatClosesACycle_RemovesTheFramesOfTheCycle()
    {
        await SendAsync(TfStatic(Frame("table")));
        await SendAsync(TfStatic(Frame("box", "arm1/tool0"), Frame("arm1/base", "box"), Frame("lid", "box")));

        await SendAsync(RosbridgeWriter.Publish("/arm1/robot_description", new StringMessage(Urdf)));
        await _gateway.Hub.Links.Read.Bounded();

        await _headset.SendAsync(RosbridgeWriter.Subscribe(RosTopics.TfStatic));
        Assert.That(new[] { await NextFramesAsync(), await NextFramesAsync() }, Is.EqualTo(new[] { "table=0", "lid=0" }));
        Assert.That(_gateway.Hub.Links.RootOf("arm1/tool0"), Is.EqualTo("arm1/base"));
        await SendAsync(TfStatic(Frame("box", "arm1/tool0")));
        await _source.SendAsync(TfStatic(Frame("arm1/base", "box")));
        await _source.ExpectErrorAsync("FrameCycle");
    }

    [TestCase(true)]
    [TestCase(false)]
    public async Task SecondSource_ForAFrame_IsRefusedUntilTheFirstUnadvertises(bool isStatic)
    {
        using var second = await RawRosbridgeClient.ConnectAsync(_gateway);
        await SendAsync(isStatic ? TfStatic(Frame("box")) : Tf(Frame("box")));

        foreach (var text in new[] { Tf(Frame("belt"), Frame("box")), TfStatic(Frame("box")) })
        {
            await second.SendAsync(text);
            await second.ExpectErrorAsync(CellMessageFaults.Of("frame box", DropReason.FrameTaken) + ", rosbridge 127.0.0.1 (FrameTaken)");
        }

        await second.SendAsync(Tf(Frame("belt")));
        await second.RoundTripAsync();
        Assert.That(_gateway.Drops[DropReason.FrameTaken], Is.EqualTo(2));
        await _source.SendAsync(RosbridgeWriter.Advertise(isStatic ? RosTopics.TfStatic : RosTopics.Tf, null));
        await SendAsync($$"""{"op":"unadvertise","topic":"{{(isStatic ? RosTopics.TfStatic : RosTopics.Tf)}}"}""");
        await second.SendAsync(Tf(Frame("box")));
        await second.RoundTripAsync();
    }

    [Test]
    public async Task Subscribe_StationaryFrames_ReceivesTheNewestOfEachChildEvenAfterTheirSourceEnded()
    {
        await SendAsync(TfStatic(Frame("belt", x: 1), Frame("fixture", x: 2)));
        await SendAsync(TfStatic(Frame("belt", x: 3)));
        await SendAsync(Tf(Frame("box", x: 4)));

        await _headset.SendAsync(RosbridgeWriter.Subscribe(RosTopics.TfStatic));

        Assert.That(new[] { await NextFramesAsync(), await NextFramesAsync() }, Is.EqualTo(new[] { "fixture=2", "belt=3" }));
        await _headset.RoundTripAsync();
        _source.Dispose();
        await Soon.BecomesAsync(() => _gateway.WebSocketConnections.Open == 1, "the source has disconnected");
        using var late = await RawRosbridgeClient.ConnectAsync(_gateway);
        await late.SendAsync(RosbridgeWriter.Subscribe(RosTopics.TfStatic));
        Assert.That((await late.ReceiveAsync()).Transforms.Text(), Is.EqualTo("fixture=2"));
        Assert.That((await late.ReceiveAsync()).Transforms.Text(), Is.EqualTo("belt=3"));
        // Another source publishes belt as a moving frame.
        await late.SendAsync(Tf(Frame("belt")));
        await late.RoundTripAsync();
        await _headset.SubscribeAsync(RosTopics.Tf);
        await _headset.SendAsync("""{"op":"subscribe","topic":"/tf_static","id":"again"}""");
        Assert.That(await NextFramesAsync(), Is.EqualTo("fixture=2"));
        await _headset.RoundTripAsync();
    }

    [Test]
    public async Task Subscribe_MovingFrames_ReceivesOnlyFramesPublishedLater()
    {
        await SendAsync(Tf(Frame("box", x: 1)));
        await _headset.SubscribeAsync(RosTopics.Tf);

        await SendAsync(Tf(Frame("box", x: 2)));

        Assert.That(await NextFramesAsync(), Is.EqualTo("box=2"));
    }

    [Test]
    public async Task Publish_LongMessage_IsForwardedInPartsOf64KiB()
    {
        await _headset.SubscribeAsync(RosTopics.Tf, "tf2_msgs/TFMessage");
        var frames = Enumerable.Range(0, 256).Select(i => Frame($"{new string('f', 60)}_{i}", i % 2 == 0 ? "world" : "belt", 0.1 + i)).ToArray();
        // Without spaces, decimals and optional fields, this text is shorter than the text that the gateway writes for the same frames.
        var text = Tf(frames).Replace(".0,", ",").Replace(".0}", "}");
        Assert.That(text.Length, Is.InRange(50_000, 64 * 1024));

        await SendAsync(text);

        var read = 0;
        // ReceiveAsync fails if a message is longer than a client accepts.
        while (read < frames.Length) read += (await _headset.ReceiveAsync()).Transforms.Count;
        Assert.That(read, Is.EqualTo(frames.Length));
        Assert.That(_gateway.Drops.Total, Is.Zero);
    }
}
