using System.Net;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Status.Events;
using Nowpose.Network;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status.Faults;

/// <summary>Tests how state and event list report headsets without a current pose and lost headsets.</summary>
public class HeadsetFaultTests
{
    MonitoredGateway _gateway;

    [SetUp]
    public void SetUp() => _gateway = new MonitoredGateway();

    [TearDown]
    public Task Close() => _gateway.DisposeAsync().AsTask();

    [Test]
    public async Task Headset_PoseNotCurrentThenLost_AddsTwoEventsAndTheGatewayStaysReady()
    {
        await StartWithHeadsetAsync();
        _gateway.Report("goggles", ("pose", "incomplete"), ("missing_joints", "a,b"));
        await _gateway.BeginsAsync("headset", "goggles");
        Assert.That((await _gateway.EventAsync("headset", "goggles")).GetProperty("reason").GetString(), Does.Contain("a,b"));
        Assert.That((await _gateway.StateAsync()).GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("warning"));
        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }), "the gateway can serve other headsets");

        _gateway.Report("goggles", ("pose", "coarse"));
        await _gateway.EndsAsync("headset", "goggles");
        _gateway.Time.Advance(TimeSpan.FromSeconds(4));

        await Soon.BecomesAsync(() => _gateway.EventAsync("headset", "goggles").Result.GetProperty("what").GetString() == "is lost", "the headset is reported as lost");
    }

    [Test]
    public async Task Headset_PoseNotCurrentDirectlyAfterItsStart_AddsAnEventOnlyIfItLasts()
    {
        await _gateway.StartAsync();
        _gateway.Time.Advance(TimeSpan.FromMinutes(1));
        _gateway.Report("quick", ("pose", "held"), ("missing_joints", "a"));
        _gateway.Report("slow", ("pose", "unsynchronised"));
        _gateway.Time.Advance(TimeSpan.FromSeconds(2));
        _gateway.Report("quick", ("pose", "current"));
        _gateway.Report("slow", ("pose", "unsynchronised"));
        _gateway.Time.Advance(TimeSpan.FromSeconds(2));
        await _gateway.BeginsAsync("headset", "slow");

        var events = (await _gateway.StateAsync()).GetProperty("events").EnumerateArray().Select(one => one.GetProperty("which").GetString());
        Assert.That(events, Is.EqualTo(new[] { "slow" }));
    }

    [Test]
    public async Task Headset_MissingJointNamedLikeANumber_IsCounted()
    {
        await StartWithHeadsetAsync();
        _gateway.Report("goggles", ("pose", "incomplete"), ("missing_joints", "3"));

        await _gateway.BeginsAsync("headset", "goggles");

        Assert.That((await _gateway.EventAsync("headset", "goggles")).GetProperty("reason").GetString(), Does.EndWith("3"));
        Assert.That((await _gateway.GetAsync("/metrics")).Text, Does.Contain("nowpose_headset_missing_joints{headset=\"goggles\"} 1\n"));
    }

    [TestCase("goggles", "headset", "goggles")]
    [TestCase("plant/press", "adapter", "press")]
    public async Task Client_WithAnotherVersion_CausesAWarningWithBothVersions(string hardwareId, string kind, string name)
    {
        await _gateway.StartAsync();
        _gateway.Report(hardwareId, ("pose", "current"), ("state", "connected"), ("version", "9.9.9"));

        await _gateway.BeginsAsync(kind, name);

        var found = await _gateway.EventAsync(kind, name);
        Assert.That(found.GetProperty("reason").GetString(), Does.Contain("9.9.9").And.Contain(NowposeVersion.Text));
        Assert.That(found.GetProperty("level").GetString(), Is.EqualTo("warning"));
        Assert.That((await _gateway.GetAsync("/metrics")).Text, Does.Contain($"nowpose_version_mismatches{{kind=\"{kind}\"}} 1\n"));
        _gateway.Report(hardwareId, ("pose", "current"), ("state", "connected"), ("version", NowposeVersion.Text));
        await _gateway.EndsAsync(kind, name);
    }

    static readonly string[][] NotCurrent =
    [
        ["held", "a", $"{EventTexts.MissingJoints("held", "a")}. {EventRemedies.MissingJoints}"],
        ["incomplete", "a", $"{EventTexts.MissingJoints("incomplete", "a")}. {EventRemedies.MissingJoints}"],
        ["held", "", $"{EventTexts.Pose("held")}. {EventRemedies.LateSamples}"],
    ];

    [TestCaseSource(nameof(NotCurrent))]
    public async Task Headset_PoseNotCurrent_EventContainsTheCauseAndARemedy(string pose, string missing, string expected)
    {
        await StartWithHeadsetAsync();

        _gateway.Report("goggles", ("pose", pose), ("missing_joints", missing));

        await _gateway.BeginsAsync("headset", "goggles");
        Assert.That(
            (await _gateway.EventAsync("headset", "goggles")).GetProperty("text").GetString(),
            Is.EqualTo($"headset goggles {EventTexts.NoCurrentPose}: {expected}"));
    }

    [Test]
    public async Task Headset_LinkDisposedWhileReceiving_IsNotLost()
    {
        await _gateway.StartAsync();
        var settings = new ConnectionSettings("127.0.0.1", webSocketPort: _gateway.Server.WebSocketEndPoint.Port);
        using var link = new SystemWebSocketLink(settings, new StopwatchHeadsetClock());
        await link.OpenAsync(CancellationToken.None).Bounded();
        await link.SendAsync(
            RosbridgeWriter.Publish(
                RosTopics.Diagnostics, new DiagnosticsMessage(Gateways.Start, "goggles", [KeyValuePair.Create("pose", "current")]), RosTimeForm.Sec),
            CancellationToken.None).Bounded();
        await Soon.BecomesAsync(() => _gateway.StateAsync().Result.GetProperty("headsets").GetArrayLength() == 1, "it is known");
        using var stop = new CancellationTokenSource();
        var receiving = link.ReceiveAsync(_ => { }, stop.Token);

        await stop.CancelAsync();
        Assert.That(async () => await receiving.Bounded(), Throws.InstanceOf<OperationCanceledException>());
        link.Dispose();

        await Soon.BecomesAsync(() => _gateway.StateAsync().Result.GetProperty("headsets").GetArrayLength() == 0, "the headset is no longer listed");
    }

    // Codes of RFC 6455, 7.4.1: normal closure (1000), going away (1001), none, and an unexpected condition (1011). Null: no close frame.
    [TestCase("03E8", false)]
    [TestCase("03E9", false)]
    [TestCase("", false)]
    [TestCase("03F3", true)]
    [TestCase(null, true)]
    public async Task Headset_ConnectionEnds_IsLostUnlessClosedNormally(string close, bool isLost)
    {
        await _gateway.StartAsync();
        using var client = await RawWebSocket.OpenAsync(_gateway.Server);
        await client.SendTextAsync(RosbridgeWriter.Publish(
            RosTopics.Diagnostics, new DiagnosticsMessage(Gateways.Start, "goggles", [KeyValuePair.Create("pose", "current")]), RosTimeForm.Sec));
        await Soon.BecomesAsync(() => _gateway.StateAsync().Result.GetProperty("headsets").GetArrayLength() == 1, "it is known");

        if (close != null) await client.SendFrameAsync(RawWebSocket.Close, Convert.FromHexString(close));
        client.EndSending();
        await Soon.BecomesAsync(() => _gateway.Server.WebSocketConnections.Open == 0, "the connection has ended");
        _gateway.Time.Advance(TimeSpan.FromSeconds(4));

        var state = await _gateway.StateAsync();
        var status = state.GetProperty("status");
        Assert.That(state.GetProperty("headsets").GetArrayLength(), Is.EqualTo(isLost ? 1 : 0), state.GetRawText());
        Assert.That(status.GetProperty("level").GetString(), Is.EqualTo("warning"), "the headset is a warning even while no source publishes");
        Assert.That(status.GetProperty("text").GetString().Contains(EventTexts.HeadsetLost), Is.EqualTo(isLost));
    }

    // Starts the gateway and a headset whose first seconds are over.
    async Task StartWithHeadsetAsync()
    {
        await _gateway.StartAsync();
        _gateway.Report("goggles", ("pose", "current"));
        _gateway.Time.Advance(EventList.StartGrace);
    }
}
