using System.Net;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Plants;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Cell.CellTexts;

namespace Nowpose.Headless.Tests.Gateway.Status.Faults;

/// <summary>Tests how state, /readyz and event list report missing sources, invalid samples, and a second source of a joint.</summary>
public class SourceFaultTests
{
    MonitoredGateway _gateway;

    [SetUp]
    public void SetUp() => _gateway = new MonitoredGateway();

    [TearDown]
    public Task Close() => _gateway.DisposeAsync().AsTask();

    [TestCase("null", 5000, DropReason.NotFinite)]
    [TestCase("NaN", 5000, DropReason.NotFinite)]
    [TestCase("\"1\"", 5000, DropReason.WrongType)]
    [TestCase("1.5", 50000, DropReason.StampInFuture)]
    public async Task Joints_SourceSendsInvalidSamples_AreRefusedWithTheNameOfTheJoint(string position, int seconds, DropReason reason)
    {
        await _gateway.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        await client.SendAsync(RosbridgeWriter.Publish(RosTopics.JointStates, Gateways.State(1, "a", "b"), RosTimeForm.Sec));
        await Soon.BecomesAsync(() => _gateway.StateAsync().Result.GetProperty("joints").GetArrayLength() == 2, "both joints are known");
        _gateway.Time.Advance(TimeSpan.FromSeconds(2));

        await client.SendAsync("{\"op\":\"publish\",\"topic\":\"/joint_states\",\"msg\":{\"header\":{\"stamp\":{\"sec\":" + seconds
            + ",\"nanosec\":0}},\"name\":[\"a\",\"b\"],\"position\":[0.5," + position + "]}}");
        Assert.That((await client.ReceiveAsync()).Text, Does.Contain("dropped"));

        await Soon.BecomesAsync(
            () => _gateway.StateAsync().Result.GetProperty("joints").EnumerateArray()
                .All(joint => joint.GetProperty("state").GetString() == "refused"),
            "both sources are refused");
        var lines = await _gateway.ReadyAsync(HttpStatusCode.ServiceUnavailable);
        Assert.That(lines, Has.Length.EqualTo(3));
        Assert.That(lines[1], Does.StartWith(Refused("a", "b", position, reason)));
    }

    // In the second case the time stamp is 30 s ahead of the control clock.
    [TestCase("NaN", 5000, DropReason.NotFinite)]
    [TestCase("1.5", 5030, DropReason.StampInFuture)]
    public async Task Joints_SourceSendsNoValidSample_AreRefusedWhileTheJointOfAnotherSourceIsLive(string position, int seconds, DropReason reason)
    {
        await _gateway.StartAsync();
        _gateway.Publish("a");
        using var client = await RawRosbridgeClient.ConnectAsync(_gateway.Server);

        await client.SendAsync(Invalid("c", seconds, position));
        Assert.That((await client.ReceiveAsync()).Text, Does.Contain("dropped"));

        var lines = await _gateway.ReadyAsync(HttpStatusCode.ServiceUnavailable);
        Assert.That(lines, Has.Length.EqualTo(2));
        Assert.That(lines[1], Does.StartWith(Refused("c", "c", position, reason)));
        var joints = (await _gateway.StateAsync()).GetProperty("joints").EnumerateArray();
        Assert.That(joints.Select(joint => joint.GetProperty("state").GetString()), Is.EqualTo(new[] { "live", "refused" }));
        await _gateway.BeginsAsync("joint", "c (rosbridge)");
    }

    [TestCase("NaN", 5000)]
    [TestCase("1.5", 5030)]
    public async Task Joint_InInvalidSamplesFromAnotherSource_StaysLive(string position, int seconds)
    {
        await _gateway.StartAsync();
        _gateway.Publish("a");
        using var client = await RawRosbridgeClient.ConnectAsync(_gateway.Server);

        await client.SendAsync(Invalid("a", seconds, position));
        Assert.That((await client.ReceiveAsync()).Text, Does.Contain("dropped"));

        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));
        // The gateway counts the refusal after it has responded to the client, so the test must wait for the count.
        var expected = $"{EventTexts.SourceRefused("rosbridge 127.0.0.1", "joint a")}: {EventTexts.Taken("gateway", "joint")}";
        string Text() => _gateway.StateAsync().Result.GetProperty("status").GetProperty("text").GetString();
        await Soon.BecomesAsync(() => Text().StartsWith(expected, StringComparison.Ordinal), () => Text());
    }

    // The start of the line for a joint of a source whose samples are dropped because of the position of another joint or the stamp.
    static string Refused(string joint, string invalid, string position, DropReason reason)
    {
        var trouble = reason == DropReason.StampInFuture ? DropMessages.Of(reason) : $"position of joint {invalid} is {position}";
        return $"joint {joint} (rosbridge) {EventTexts.IsRefused}: {RequestMessages.Dropped("rosbridge 127.0.0.1", trouble, reason)} (since ";
    }

    static string Invalid(string joint, int seconds, string position) =>
        "{\"op\":\"publish\",\"topic\":\"/joint_states\",\"msg\":{\"header\":{\"stamp\":{\"sec\":" + seconds
        + ",\"nanosec\":0}},\"name\":[\"" + joint + "\"],\"position\":[" + position + "]}}";

    [Test]
    public async Task SecondSource_ForAJoint_AddsAnEventUntilTheSourceEnds()
    {
        await _gateway.StartAsync();
        _gateway.Publish("a");
        using var second = _gateway.Server.Hub.OpenSource();
        second.Name = "copy";

        Assert.That(second.Publish(Gateways.State(1, "a"))?.What, Is.EqualTo("a"));

        await _gateway.BeginsAsync("source", "copy of joint a");
        _gateway.Time.Advance(TimeSpan.FromSeconds(6));
        await _gateway.EndsAsync("source", "copy of joint a");
    }

    // Stationary frames and signals are sent only once, so a refusal must stay visible although no further message is refused.
    [TestCase("signal grip", "first ends")]
    [TestCase("signal grip", "second ends")]
    [TestCase("signal grip", "second unadvertises")]
    [TestCase("frame fixture", "first ends")]
    [TestCase("frame fixture", "second ends")]
    [TestCase("frame fixture", "second unadvertises")]
    public async Task SecondSource_OfASignalOrStationaryFrame_AddsAnEventUntilOneOfTheSourcesLeaves(string part, string end)
    {
        await _gateway.StartAsync();
        var isSignal = part == "signal grip";
        var leftOut = new List<LeftOut>();
        bool Send(HubSource source) => isSignal ? source.Publish(new SignalsMessage(Gateways.Start, new SignalValue("grip", 1)), leftOut)
            : source.Publish(new TransformsMessage(Frame("fixture")), isStationary: true, leftOut);
        using HubSource first = _gateway.Server.Hub.OpenSource(), second = _gateway.Server.Hub.OpenSource();
        second.Name = "copy";

        Assert.That((Send(first), Send(second)), Is.EqualTo((true, false)));
        var topic = isSignal ? RosTopics.Signals : RosTopics.TfStatic;
        second.ReportDropped(topic, leftOut.Single());

        await _gateway.BeginsAsync("source", "copy of " + part);
        _gateway.Time.Advance(TimeSpan.FromMinutes(10));
        var status = (await _gateway.StateAsync()).GetProperty("status").GetProperty("text").GetString();
        Assert.That(status, Does.Contain(EventTexts.SourceRefused("copy", part)));

        if (end == "second unadvertises") second.Release(topic);
        else (end == "first ends" ? first : second).Dispose();

        await _gateway.EndsAsync("source", "copy of " + part);
    }

    [Test]
    public async Task SecondSource_OfASignalOfAnOwnerThatChanges_NamesThePresentOwner()
    {
        await _gateway.StartAsync();
        var leftOut = new List<LeftOut>();
        HubSource Source(string name)
        {
            var source = _gateway.Server.Hub.OpenSource();
            source.Name = name;
            source.Publish(new SignalsMessage(Gateways.Start, new SignalValue("grip", 1)), leftOut);
            return source;
        }
        var first = Source("plc");
        using var second = Source("copy");
        second.ReportDropped(RosTopics.Signals, leftOut.Single());
        await _gateway.BeginsAsync("source", "copy of signal grip");
        using var third = Source("new plc");

        first.Dispose();
        _gateway.Time.Advance(TimeSpan.FromMinutes(1));

        Assert.That(
            (await _gateway.StateAsync()).GetProperty("status").GetProperty("text").GetString(), Does.Contain(EventTexts.Taken("new plc", "signal")));
    }

    [Test]
    public async Task SecondSource_WithoutAName_IsReportedWithItsAddress()
    {
        await _gateway.StartAsync();
        using var first = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        using var second = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        await first.SendAsync(Gateways.StateText(1));
        await first.RoundTripAsync();
        await second.SendAsync(Gateways.StateText(1));
        await second.ExpectErrorAsync("another source");

        Assert.That(
            (await _gateway.StateAsync()).GetProperty("status").GetProperty("text").GetString(),
            Is.EqualTo($"{EventTexts.SourceRefused("rosbridge 127.0.0.1", "joint a")}: {EventTexts.Taken("rosbridge 127.0.0.1", "joint")}. {EventRemedies.TwoSources}"));
    }

    [Test]
    public async Task SecondSource_WithoutANameReconnects_AddsOnlyOneEvent()
    {
        await _gateway.StartAsync();
        _gateway.Publish("a");
        for (var i = 0; i < 12; i++)
        {
            using var client = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
            await client.SendAsync(Gateways.StateText(1));
            await client.ExpectErrorAsync("another source");
        }

        await _gateway.BeginsAsync("source", "rosbridge 127.0.0.1 of joint a");
        Assert.That((await _gateway.StateAsync()).GetProperty("events").GetArrayLength(), Is.EqualTo(1));
    }

    [Test]
    public async Task Ready_BeforeTheFirstSource_ContainsStartTimeAndRemedy()
    {
        await _gateway.StartAsync(options => options with { ExpectsSources = true });
        // The first complete check publishes the joint status.
        var looked = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        using var listening = _gateway.Server.Hub.Subscribe(RosTopics.JointStatus, _ => looked.TrySetResult());
        await looked.Task.Bounded();
        _gateway.Time.Advance(TimeSpan.FromSeconds(75));
        await _gateway.BeginsAsync("source", "of joint positions");

        Assert.That((await _gateway.ReadyAsync(HttpStatusCode.ServiceUnavailable))[1], Is.EqualTo(
            $"{EventTexts.SourceMissing}: {EventTexts.NoSource} (since 2026-11-20 12:00:00 UTC). {EventRemedies.Adapters}"));
    }

    [TestCase(false, HttpStatusCode.OK, TestName = "Ready_PlantWithObjectsOnly_NeedsNoSourceOfJointPositions")]
    [TestCase(true, HttpStatusCode.ServiceUnavailable, TestName = "Ready_PlantWithJointsThatReportsOnlyObjects_NeedsASourceOfJointPositions")]
    public async Task Ready_OnlyObjectsAreReported_DependsOnTheJointsOfThePlant(bool hasJoints, HttpStatusCode status)
    {
        var plant = new PlantFile("press.yaml", "press", "") { HasObjects = true, PassesUnlisted = hasJoints };
        await _gateway.StartAsync(options => options with { ExpectsSources = PlantFile.ExpectsJoints([plant], null) });

        _gateway.Report("adapter/press", ("state", "connected"), ("frame/box", $"live {_gateway.Since(1)}"));

        await _gateway.ReadyAsync(status);
    }
}
