using System.Diagnostics;
using Nowpose.Gateway.Hub;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Cell.CellTexts;

namespace Nowpose.Headless.Tests.Gateway.Cell;

/// <summary>Tests that a value which a source sends only once is published as soon as the former source of the frame or signal has ended.</summary>
[FixtureLifeCycle(LifeCycle.InstancePerTestCase)]
public class RefusedValuesTests
{
    readonly MessageHub _hub = new();

    static bool Send(HubSource source, string name, double value, bool isSignal) => isSignal
        ? source.Publish(new SignalsMessage(Gateways.Start, new SignalValue("other", 0), new SignalValue(name, value)), [])
        : source.Publish(new TransformsMessage(Frame("other"), Frame(name, x: value)), isStationary: true, []);

    // Sends a value with a time stamp, in seconds; 0 for a stationary frame without a time stamp.
    static void SendAt(HubSource source, double seconds, double value, bool isSignal)
    {
        var stamp = seconds == 0 ? default : ControlTime.FromSeconds(seconds);
        if (isSignal) source.Publish(new SignalsMessage(stamp, new SignalValue("a", value)), []);
        else source.Publish(new TransformsMessage(Frame("a", x: value, stamp: stamp)), isStationary: true, []);
    }

    // The values that a new subscriber receives.
    string[] Kept(bool isSignal)
    {
        var kept = new List<string>();
        _hub.Subscribe(isSignal ? RosTopics.Signals : RosTopics.TfStatic, message => kept.Add(TextOf(message))).Dispose();
        return [.. kept];
    }

    static string TextOf(HubMessage message) => message.Content is SignalsMessage signals ? signals.Text() : ((TransformsMessage)message.Content).Text();

    [Test]
    public void Dispose_FormerSourceOfARestartedOne_PublishesTheRefusedValues([Values] bool isSignal)
    {
        var former = _hub.OpenSource();
        using var restarted = _hub.OpenSource();
        Send(former, "a", 1, isSignal);
        Assert.That(Send(restarted, "a", 2, isSignal), Is.False);
        Send(restarted, "a", 3, isSignal);
        var received = new List<string>();
        using var subscription = _hub.SubscribeToNew(isSignal ? RosTopics.Signals : RosTopics.TfStatic, message => received.Add(TextOf(message)));

        former.Dispose();

        string[] expected = isSignal ? ["other=0", "a=3"] : ["other=0 a=3"];
        Assert.That(received, Is.EqualTo(expected));
        Assert.That(Kept(isSignal), Is.EqualTo(received));
        using var third = _hub.OpenSource();
        Assert.That(Send(third, "a", 4, isSignal), Is.False, "the frame or signal belongs to the restarted source");
    }

    [Test]
    public void Dispose_RefusedSourceHasEndedToo_PublishesNoRefusedValue([Values] bool isSignal, [Values] bool isUnadvertised)
    {
        var former = _hub.OpenSource();
        var refused = _hub.OpenSource();
        Send(former, "a", 1, isSignal);
        Send(refused, "a", 2, isSignal);

        if (isUnadvertised) refused.Release(isSignal ? RosTopics.Signals : RosTopics.TfStatic);
        else refused.Dispose();
        former.Dispose();

        string[] expected = isSignal ? [] : ["other=0 a=1"];
        Assert.That(Kept(isSignal), Is.EqualTo(expected));
    }

    [Test]
    public void Dispose_TwoRefusedSources_PublishesTheValueOfTheLaterOne([Values] bool isSignal)
    {
        var former = _hub.OpenSource();
        using var second = _hub.OpenSource();
        var third = _hub.OpenSource();
        Send(former, "a", 1, isSignal);
        Send(third, "a", 2, isSignal);
        Send(second, "a", 3, isSignal);
        Send(third, "a", 4, isSignal);

        former.Dispose();
        Assert.That(string.Join(' ', Kept(isSignal)), Does.Contain("a=4"));
        third.Dispose();

        Assert.That(string.Join(' ', Kept(isSignal)), Does.Contain("a=3"));
    }

    [Test]
    public void Dispose_RefusedValuesArrivedInAnotherOrderThanTheirStamps_PublishesTheNewestByStamp([Values] bool isSignal)
    {
        var former = _hub.OpenSource();
        using var second = _hub.OpenSource();
        using var third = _hub.OpenSource();
        SendAt(former, 100, 1, isSignal);
        SendAt(second, 300, 2, isSignal);
        SendAt(third, 200, 3, isSignal);

        former.Dispose();

        Assert.That(Kept(isSignal), Is.EqualTo(new[] { "a=2" }));
    }

    // As for accepted values: a value that is late by more than a second shows that the clock of its source went back.
    [TestCase(299.0, 2)]
    [TestCase(298.9, 3)]
    public void Dispose_RefusedValueIsOlderThanThePreviousOneOfItsSource_PublishesItOnlyIfTheClockWentBack(double seconds, double expected)
    {
        foreach (var isSignal in new[] { true, false })
        {
            var former = _hub.OpenSource();
            using var refused = _hub.OpenSource();
            SendAt(former, 100, 1, isSignal);
            SendAt(refused, 300, 2, isSignal);
            SendAt(refused, seconds, 3, isSignal);

            former.Dispose();

            Assert.That(Kept(isSignal), Is.EqualTo(new[] { $"a={expected}" }));
        }
    }

    [Test]
    public void Dispose_RefusedFramesWithoutStamps_PublishesTheOneThatArrivedLast()
    {
        var former = _hub.OpenSource();
        using var second = _hub.OpenSource();
        using var third = _hub.OpenSource();
        foreach (var (source, value) in new[] { (former, 1.0), (third, 2.0), (second, 3.0) }) SendAt(source, 0, value, isSignal: false);

        former.Dispose();

        Assert.That(Kept(isSignal: false), Is.EqualTo(new[] { "a=3" }));
    }

    [Test]
    public void Dispose_NewestRefusedPoseWouldCloseACycle_ReportsItAndPublishesTheNextOne()
    {
        var former = _hub.OpenSource();
        using var second = _hub.OpenSource();
        using var third = _hub.OpenSource();
        former.Publish(new TransformsMessage(Frame("a"), Frame("b")), isStationary: false, []);
        second.Publish(new TransformsMessage(Frame("a", x: 2)), isStationary: true, []);
        third.Publish(new TransformsMessage(Frame("part", "a")), isStationary: false, []);
        third.Publish(new TransformsMessage(Frame("a", "part")), isStationary: true, []);
        var dropped = new List<(HubSource, string, DropReason, string)>();
        _hub.PartDropped += (source, topic, part) => dropped.Add((source, topic, part.Reason, part.Name));

        former.Dispose();

        Assert.That(Kept(isSignal: false), Is.EqualTo(new[] { "a=2" }));
        Assert.That(dropped, Is.EqualTo(new[] { (third, RosTopics.TfStatic, DropReason.FrameCycle, "a") }));
    }

    // The first pose is possible only after the second one, because a stationary frame keeps its parent.
    [Test]
    public void Dispose_RefusedMessageExchangesParents_PublishesBothPoses()
    {
        var former = _hub.OpenSource();
        using var refused = _hub.OpenSource();
        former.Publish(new TransformsMessage(Frame("a"), Frame("b", "a")), isStationary: true, []);
        refused.Publish(new TransformsMessage(Frame("a", "b", x: 2), Frame("b", x: 2)), isStationary: true, []);

        former.Dispose();

        Assert.That(Kept(isSignal: false), Is.EqualTo(new[] { "b=2 a=2" }));
    }

    [Test]
    public async Task Describe_RobotClosesACycleWithTheOwnersFrame_PublishesTheRefusedPose()
    {
        using var owner = _hub.OpenSource();
        using var refused = _hub.OpenSource();
        owner.Publish(new TransformsMessage(Frame("base", "tool")), isStationary: true, []);
        refused.Publish(new TransformsMessage(Frame("base", x: 2)), isStationary: true, []);

        owner.Describe("<robot name='r'><link name='base'/><link name='tool'/><joint name='j' type='fixed'><parent link='base'/><child link='tool'/></joint></robot>");
        await _hub.Links.Read;

        Assert.That(Kept(isSignal: false), Is.EqualTo(new[] { "base=2" }));
    }

    [Test]
    public void Publish_NewFrameReplacesASilentFrame_PublishesTheRefusedPoseOfTheSilentFrame()
    {
        using var owner = _hub.OpenSource();
        using var refused = _hub.OpenSource();
        Fill(owner);
        refused.Publish(new TransformsMessage(Frame("part0", x: 2)), isStationary: true, []);

        PublishMoving(owner, seconds: 20, "new");

        Assert.That(Kept(isSignal: false), Is.EqualTo(new[] { "part0=2" }));
    }

    [Test]
    public void Release_SourceTracksItsRefusedFrameSinceTheFrameWasReplaced_PublishesNoRefusedPose()
    {
        using var owner = _hub.OpenSource();
        using var refused = _hub.OpenSource();
        Fill(owner);
        refused.Publish(new TransformsMessage(Frame("part0", x: 2)), isStationary: true, []);
        PublishMoving(refused, seconds: 20, "new", "part0");

        refused.Release(RosTopics.Tf);

        Assert.That(Kept(isSignal: false), Is.Empty);
    }

    static void SendInvalid(HubSource source, string name) =>
        source.ReportDropped(RosTopics.TfStatic, new LeftOut(DropReason.NotFinite, name, "is wrong"));

    List<(HubSource Source, string Name)> Dropped()
    {
        var dropped = new List<(HubSource, string)>();
        _hub.PartDropped += (source, _, part) => dropped.Add((source, part.Name));
        return dropped;
    }

    [Test]
    public void Dispose_RefusedPosesAndLaterInvalidOnes_PublishesThePoseThatArrivedLastAndReportsTheInvalidOnes()
    {
        var former = _hub.OpenSource();
        using var second = _hub.OpenSource();
        using var third = _hub.OpenSource();
        using var fourth = _hub.OpenSource();
        former.Publish(new TransformsMessage(Frame("a"), Frame("b")), isStationary: false, []);
        foreach (var (source, value) in new[] { (second, 2.0), (third, 3.0) }) SendAt(source, 0, value, isSignal: false);
        foreach (var source in new[] { third, second, fourth }) SendInvalid(source, "a");
        SendInvalid(fourth, "b");
        var dropped = Dropped();

        former.Dispose();

        Assert.That(Kept(isSignal: false), Is.EqualTo(new[] { "a=3" }));
        Assert.That(dropped, Is.EquivalentTo(new[] { (third, "a"), (fourth, "b") }), "the frame a belongs to the third source");
    }

    [Test]
    public void Publish_ValidPoseAfterAnInvalidOneThatWasKept_ReportsNoInvalidPose()
    {
        using var owner = _hub.OpenSource();
        using var refused = _hub.OpenSource();
        Fill(owner);
        SendInvalid(refused, "part0");
        var dropped = Dropped();

        PublishMoving(refused, seconds: 20, "new", "part0");

        Assert.That(dropped, Is.Empty);
    }

    static void Fill(HubSource owner)
    {
        for (var i = 0; i < ProtocolLimits.Frames; i++) PublishMoving(owner, seconds: 0, "part" + i);
    }

    static void PublishMoving(HubSource source, double seconds, params string[] names) => source.Publish(
        new TransformsMessage([.. names.Select(name => Frame(name))]), isStationary: false, [], 1 + (long)(seconds * Stopwatch.Frequency));
}
