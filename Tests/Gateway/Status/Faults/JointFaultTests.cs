using System.Net;
using System.Text.Json;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status.Faults;

/// <summary>Tests how state, /readyz, metrics and event list report joints without current samples.</summary>
public class JointFaultTests
{
    MonitoredGateway _gateway;

    [SetUp]
    public void SetUp() => _gateway = new MonitoredGateway();

    [TearDown]
    public Task Close() => _gateway.DisposeAsync().AsTask();

    [Test]
    public async Task Joint_SamplesStop_IsReportedEverywhereWithinTwoSecondsAndRecoversImmediately()
    {
        await _gateway.StartAsync();
        _gateway.Publish("a", "b");
        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));

        _gateway.Time.Advance(TimeSpan.FromSeconds(1));
        _gateway.Publish("b");
        _gateway.Time.Advance(TimeSpan.FromSeconds(1));

        var lines = await _gateway.ReadyAsync(HttpStatusCode.ServiceUnavailable);
        Assert.That(lines, Has.Length.EqualTo(2), "the other joint continues");
        Assert.That(lines[0], Is.EqualTo("waiting"));
        Assert.That(lines[1], Does.StartWith($"joint a (gateway) {EventTexts.Is("stale")}: "));
        var state = await _gateway.StateAsync();
        var joint = state.GetProperty("joints")[0];
        Assert.That(joint.GetProperty("state").GetString(), Is.EqualTo("stale"));
        Assert.That(joint.GetProperty("since_utc").GetString(), Is.EqualTo("2026-11-20T12:00:00.000Z"));
        Assert.That(joint.GetProperty("reason").GetString(), Is.Not.Empty);
        Assert.That(state.GetProperty("joints")[1].GetProperty("state").GetString(), Is.EqualTo("live"));
        Assert.That(state.GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("error"));
        Assert.That(state.GetProperty("status").GetProperty("text").GetString(), Does.Contain("joint a"));
        var metrics = (await _gateway.GetAsync("/metrics")).Text;
        Assert.That(metrics, Does.Contain("nowpose_joint_state{joint=\"a\",source=\"gateway\",state=\"stale\"} 1"));
        Assert.That(metrics, Does.Contain("nowpose_ready 0"));
        await _gateway.BeginsAsync("joint", "a (gateway)");

        _gateway.Publish("a");

        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));
        Assert.That((await _gateway.StateAsync()).GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("ok"));
        await _gateway.EndsAsync("joint", "a (gateway)");
        Assert.That(_gateway.Log.Count(line => line.Contains("joint a (gateway) " + EventTexts.Is("stale"))), Is.EqualTo(2), string.Join('\n', _gateway.Log));
    }

    [TestCase("refused", EventTexts.IsRefused, EventRemedies.Values)]
    [TestCase("missing", EventTexts.IsMissing, EventRemedies.MissingJoint)]
    [TestCase("fault", EventTexts.InFault, EventRemedies.Plant)]
    public async Task Joint_AdapterReportsAFault_IsReportedWithReasonStartAndRemedy(string word, string what, string remedy)
    {
        await _gateway.StartAsync(options => options with { ExpectsSources = true });
        _gateway.Publish("a", "b");

        _gateway.Report(
            "adapter/press", ("state", "connected"), ("joint/a", $"{word} {_gateway.Since(90)} the node ns=2;s=Axis1 is gone"), ("reason/a", "node-gone"),
            ("joint/b", $"live {_gateway.Since()} "));

        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.ServiceUnavailable), Is.EqualTo(new[]
        {
            "waiting", $"joint a (press) {what}: the node ns=2;s=Axis1 is gone (since 2026-11-20 11:58:30 UTC). {remedy}",
        }));
        var joints = (await _gateway.StateAsync()).GetProperty("joints");
        Assert.That(joints.GetArrayLength(), Is.EqualTo(2));
        Assert.That(joints[0].GetProperty("source").GetString(), Is.EqualTo("press"));
        Assert.That(joints[0].GetProperty("since_utc").GetString(), Is.EqualTo("2026-11-20T11:58:30.000Z"));
        Assert.That(joints[0].GetProperty("reason_word").GetString(), Is.EqualTo("node-gone"));
        Assert.That(joints[1].GetProperty("state").GetString(), Is.EqualTo("live"));
        var metrics = (await _gateway.GetAsync("/metrics")).Text;
        Assert.That(metrics, Does.Contain($"nowpose_joint_state{{joint=\"a\",source=\"press\",state=\"{word}\"}} 1"));
        Assert.That(metrics, Does.Contain("nowpose_joint_fault{joint=\"a\",source=\"press\",reason=\"node-gone\"} 1"));
        var adapter = (await _gateway.StateAsync()).GetProperty("adapters")[0];
        Assert.That(adapter.TryGetProperty("reason/a", out _), Is.False, "the word belongs to the joint");
    }

    [TestCase("never-received", EventRemedies.MissingJoint)]
    [TestCase("stamp-old", EventRemedies.Values)]
    [TestCase("type", EventRemedies.Values)]
    public async Task Joint_MissingBecauseOfItsValues_HasTheRemedyForTheValues(string reason, string remedy)
    {
        await _gateway.StartAsync(options => options with { ExpectsSources = true });

        _gateway.Report("adapter/press", ("state", "connected"), ("joint/a", $"missing {_gateway.Since(90)} why"), ("reason/a", reason));

        Assert.That((await _gateway.ReadyAsync(HttpStatusCode.ServiceUnavailable))[1], Does.EndWith(remedy));
    }

    [Test]
    public async Task Ready_JointAtRest_IsReady()
    {
        await _gateway.StartAsync(options => options with { ExpectsSources = true });
        _gateway.Publish("a");
        _gateway.Time.Advance(TimeSpan.FromSeconds(100));

        _gateway.Report("adapter/press", ("state", "connected"), ("joint/a", $"rest {_gateway.Since(99)} assumed at rest"));

        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));
        Assert.That((await _gateway.StateAsync()).GetProperty("joints")[0].GetProperty("state").GetString(), Is.EqualTo("rest"));
        Assert.That((await _gateway.StateAsync()).GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("ok"));
    }

    [Test]
    public async Task Joint_RestUncertain_IsAWarningUntilItMoves()
    {
        await _gateway.StartAsync(options => options with { ExpectsSources = true });
        _gateway.Publish("a");

        _gateway.Report(
            "adapter/press", ("state", "connected"), ("joint/a", $"rest {_gateway.Since(3)} assumed at rest"),
            ("uncertain/a", "the stop itself was not observed"));

        await _gateway.BeginsAsync("joint", "a (press)");
        var status = (await _gateway.StateAsync()).GetProperty("status");
        Assert.That(
            (await _gateway.StateAsync()).GetProperty("joints")[0].GetProperty("uncertain").GetString(),
            Is.EqualTo("the stop itself was not observed"));
        Assert.That((await _gateway.GetAsync("/metrics")).Text, Does.Contain("nowpose_joint_rest_uncertain{joint=\"a\",source=\"press\"} 1"));
        Assert.That(status.GetProperty("level").GetString(), Is.EqualTo("warning"));
        Assert.That(status.GetProperty("text").GetString(), Is.EqualTo(
            $"joint a (press) {EventTexts.UncertainRest}: the stop itself was not observed. {EventRemedies.SetDeceleration}"));
        Assert.That(status.GetProperty("since_utc").GetString(), Is.EqualTo("2026-11-20T11:59:57.000Z"));
        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));

        _gateway.Report("adapter/press", ("state", "connected"), ("joint/a", $"live {_gateway.Since()} "));

        await _gateway.EndsAsync("joint", "a (press)");
        Assert.That((await _gateway.StateAsync()).GetProperty("joints")[0].TryGetProperty("uncertain", out _), Is.False);
        Assert.That((await _gateway.GetAsync("/metrics")).Text, Does.Contain("nowpose_joint_rest_uncertain{joint=\"a\",source=\"press\"} 0"));
    }

    [Test]
    public async Task Joint_RestUncertainWithAdapterRemedy_HasOnlyThatRemedy()
    {
        await _gateway.StartAsync();
        _gateway.Publish("a");

        _gateway.Report(
            "adapter/press", ("state", "connected"), ("joint/a", $"rest {_gateway.Since(3)} assumed at rest"),
            ("uncertain/a", "nothing confirms it; set silence"));

        await _gateway.BeginsAsync("joint", "a (press)");
        Assert.That(
            (await _gateway.StateAsync()).GetProperty("status").GetProperty("text").GetString(),
            Does.EndWith("nothing confirms it; set silence. " + EventRemedies.CheckRest));
    }

    [TestCase(null, "error")]
    [TestCase("03F3", "error")]
    [TestCase("03E8", "warning")]
    public async Task Joint_ClientDisconnected_StaysInFaultUnlessClosedNormally(string close, string level)
    {
        await _gateway.StartAsync();
        using var client = await RawWebSocket.OpenAsync(_gateway.Server);
        await client.SendTextAsync(Gateways.StateText(1));
        await Soon.BecomesAsync(() => _gateway.StateAsync().Result.GetProperty("joints").GetArrayLength() == 1, "it is published");

        if (close != null) await client.SendFrameAsync(RawWebSocket.Close, Convert.FromHexString(close));
        client.EndSending();
        await Soon.BecomesAsync(() => _gateway.Server.WebSocketConnections.Open == 0, "the connection has ended");
        _gateway.Time.Advance(TimeSpan.FromHours(30));

        var state = await _gateway.StateAsync();
        Assert.That(state.GetProperty("status").GetProperty("level").GetString(), Is.EqualTo(level), state.GetRawText());
        Assert.That(state.GetProperty("joints").GetArrayLength(), Is.EqualTo(level == "error" ? 1 : 0));
    }

    [Test]
    public async Task JointStatus_Subscribed_ContainsTheJointsThatAreNotLive()
    {
        await _gateway.StartAsync();
        _gateway.Publish("a", "b");
        _gateway.Report(
            "adapter/press", ("state", "connected"), ("joint/a", $"refused {_gateway.Since(5)} status Bad"),
            ("joint/b", $"live {_gateway.Since()} "));
        using var client = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        // The gateway may publish the status before it responds to the request, so all messages until the status are read.
        await client.SendAsync(RosbridgeWriter.Subscribe(RosTopics.JointStatus, "diagnostic_msgs/DiagnosticArray"));

        JsonElement status;
        do status = JsonDocument.Parse(await client.ReceiveTextAsync()).RootElement.GetProperty("msg").GetProperty("status")[0];
        while (status.GetProperty("values").GetArrayLength() == 0);

        Assert.That(status.GetProperty("hardware_id").GetString(), Is.EqualTo("gateway"));
        var value = status.GetProperty("values").EnumerateArray().Single();
        Assert.That(value.GetProperty("key").GetString(), Is.EqualTo("a"));
        var words = value.GetProperty("value").GetString().Split(' ', 3);
        Assert.That((words[0], words[2]), Is.EqualTo(("refused", "status Bad")));
        var since = double.Parse(words[1], System.Globalization.CultureInfo.InvariantCulture);
        Assert.That(
            since, Is.InRange(Gateways.Start.SinceEpoch.TotalSeconds - 5.01, _gateway.Server.Clock.Now.SinceEpoch.TotalSeconds - 4.9),
            "on the control clock");
    }

    [Test]
    public async Task Joint_OutsideItsLimits_IsReportedWithPositionLimitsAndUnit()
    {
        await _gateway.StartAsync();
        using var description = _gateway.Server.Hub.OpenSource();
        description.Describe(RobotFiles.LoadText("youbot"));

        await Soon.BecomesAsync(
            () =>
            {
                _gateway.Source.Publish(Gateways.State(200, "arm_joint_3"));
                return _gateway.EventAsync("limit", "arm_joint_3").Result.ValueKind == JsonValueKind.Object;
            },
            "the joint is outside its limits");

        var one = await _gateway.EventAsync("limit", "arm_joint_3");
        Assert.That(one.GetProperty("what").GetString(), Is.EqualTo(EventTexts.IsExceeded));
        var limits = RobotFiles.Load("youbot").MovingJoints.Single(joint => joint.Name == "arm_joint_3").Limits;
        Assert.That(one.GetProperty("text").GetString(), Is.EqualTo(
            $"{EventTexts.JointBeyondLimits("arm_joint_3")}: {EventTexts.BeyondLimits(200, "rad", limits.Lower, limits.Upper)}. "
                + EventRemedies.Limits("rad", "deg")));

        // Afterwards the position is not known, and the joint itself has an event.
        _gateway.Time.Advance(JointBoard.StaleAfter);

        await _gateway.EndsAsync("limit", "arm_joint_3");
    }

    [Test]
    public async Task Description_Invalid_IsAnEventUntilAValidDescriptionArrives()
    {
        const string Topic = "/arm1" + RosTopics.RobotDescription;
        await _gateway.StartAsync();
        _gateway.Source.Describe("<robot><link name=\"a\"/>", "arm1");

        await _gateway.BeginsAsync("description", Topic);

        var one = await _gateway.EventAsync("description", Topic);
        Assert.That(one.GetProperty("text").GetString(), Does.StartWith(EventTexts.InvalidDescription("arm1") + ": ").And.EndWith(EventRemedies.Description));
        Assert.That((await _gateway.StateAsync()).GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("error"));
        await _gateway.ReadyAsync(HttpStatusCode.OK);
        _gateway.Source.Describe(RobotFiles.LoadText("youbot"), "arm1");
        await _gateway.EndsAsync("description", Topic);
    }

    [Test]
    public async Task Joint_OfTheRobotWithoutASource_IsReportedEverywhere()
    {
        await _gateway.StartAsync();
        _gateway.Source.Describe(RobotFiles.LoadText("youbot"));
        string[] all = [.. UnpublishedJoints.NamesOf(RobotFiles.Load("youbot"))];
        _gateway.Publish(all[1..]);
        await Soon.BecomesAsync(() => IsDescribed(all), "the description is read");
        _gateway.Time.Advance(UnpublishedJoints.StartTimeout);
        _gateway.Publish(all[1..]);

        var reasons = await _gateway.ReadyAsync(HttpStatusCode.ServiceUnavailable);

        Assert.That(reasons[1..], Has.Length.EqualTo(1).And.Some.Contains($"joint {all[0]} (no source) {EventTexts.IsMissing}"));
        Assert.That((await _gateway.StateAsync()).GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("error"));
        Assert.That((await _gateway.GetAsync("/metrics")).Text, Does.Contain($"joint=\"{all[0]}\",source=\"no source\",state=\"missing\"}} 1"));
        _gateway.Publish(all);
        await _gateway.ReadyAsync(HttpStatusCode.OK);
    }

    // Advances the time, so that the gateway finds the joint without a source as soon as it has the robot description.
    bool IsDescribed(string[] all)
    {
        _gateway.Time.Advance(TimeSpan.FromMilliseconds(100));
        _gateway.Publish(all[1..]);
        return _gateway.StateAsync().Result.GetProperty("joints").GetArrayLength() == all.Length;
    }
}
