using System.Net;
using System.Text.Json;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Status;
using Nowpose.Headless.Tests.Gateway.Clock;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Status.StatusRequests;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>Tests the state that the operations page reads.</summary>
public class OperationsStateTests
{
    static DiagnosticsMessage Diagnostics(string name, params (string Key, string Value)[] values) =>
        new(Gateways.Start, name, [.. values.Select(pair => KeyValuePair.Create(pair.Key, pair.Value))]);

    [Test]
    public async Task State_JointOutsideTheLimitsOfTheDescription_ContainsTheJoint()
    {
        await using var gateway = await Gateways.StartAsync();
        using var source = gateway.Hub.OpenSource();
        source.Describe(RobotFiles.LoadText("ur5"));
        var isNamed = false;

        for (var tries = 0; !isNamed && tries < 400; tries++)
        {
            source.Publish(new JointStateMessage(Gateways.Start, ["wrist_1_joint", "wrist_2_joint"], [-45, 1]));
            var sources = (await StateAsync(gateway)).GetProperty("sources").EnumerateArray();
            var named = sources.Single().GetProperty("beyond_limits").EnumerateArray().Select(joint => joint.GetString());
            isNamed = named.SequenceEqual(["wrist_1_joint"]);
        }

        Assert.That(isNamed, "within 400 samples, during which the description is read");
        Assert.That((await GetAsync(gateway, "/metrics")).Text, Does.Match("(?m)^nowpose_source_beyond_limits{.*} 1$"));
    }

    [Test]
    public async Task State_SignalsWithoutARobot_IsOkUntilARobotIsDescribed()
    {
        await using var gateway = await Gateways.StartAsync();
        using var source = gateway.Hub.OpenSource();
        async Task<string> LevelAsync() => (await StateAsync(gateway)).GetProperty("status").GetProperty("level").GetString();
        Assert.That(await LevelAsync(), Is.EqualTo("warning"));

        source.Publish(new SignalsMessage(Gateways.Start, new SignalValue("closed", 1)), []);
        Assert.That(await LevelAsync(), Is.EqualTo("ok"));

        using var robot = gateway.Hub.OpenSource();
        robot.Describe(RobotFiles.LoadText("ur5"));
        await Soon.BecomesAsync(() => LevelAsync().Result == "warning", "its joints are missing");
    }

    [Test]
    public async Task State_AfterTraffic_ContainsSourcesHeadsetsAndAdapters()
    {
        var clock = new StopwatchControlClock(Gateways.Start);
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Cell = "press" }, clock);
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates);
        using var source = gateway.Hub.OpenSource();
        for (var i = 0; i < 20; i++)
        {
            source.Publish(new JointStateMessage(clock.Now - TimeSpan.FromMilliseconds(80), ["a", "b"], [1, 2]));
            await client.ReceiveAsync();
        }
        // The client may receive the last message before the gateway records the forwarding time of this message.
        await Soon.BecomesAsync(() => gateway.Hub.Forwarding.Counts().Sum() == 20, "all messages are counted");
        source.Publish(RosTopics.Diagnostics, Diagnostics(
            "goggles", ("state", "synchronised"), ("rtt_ms", "4"), ("l_app_ms", "95"), ("render_ms", "12"), ("l_visu_ms", "42"), ("budget_ms", "x")));
        source.Publish(RosTopics.Diagnostics, Diagnostics("plant/press", ("kind", "opcua"), ("state", "connected"), ("samples", "20")));

        var state = await StateAsync(gateway);

        Assert.That(state.GetProperty("cell").GetString(), Is.EqualTo("press"));
        Assert.That(state.GetProperty("role").GetString(), Is.EqualTo("operator"), "a browser on this machine has all rights");
        Assert.That(state.GetProperty("control_time_s").GetDouble(), Is.EqualTo(clock.Now.SinceEpoch.TotalSeconds).Within(20));
        var joints = state.GetProperty("sources")[0];
        Assert.That(joints.GetProperty("joints").EnumerateArray().Select(name => name.GetString()), Is.EqualTo(new[] { "a", "b" }));
        Assert.That(joints.GetProperty("age_ms").GetProperty("p50").GetDouble(), Is.EqualTo(80).Within(20));
        var headset = state.GetProperty("headsets")[0];
        Assert.That(headset.GetProperty("name").GetString(), Is.EqualTo("goggles"));
        Assert.That(headset.GetProperty("l_app_ms").GetDouble(), Is.EqualTo(95), "a number is written as a JSON number");
        Assert.That(headset.GetProperty("state").GetString(), Is.EqualTo("synchronised"));
        AssertBudget(headset.GetProperty("budget_ms"), state.GetProperty("forward_ms").GetProperty("p50").GetDouble());
        var adapter = state.GetProperty("adapters")[0];
        Assert.That(adapter.GetProperty("name").GetString(), Is.EqualTo("press"));
        Assert.That(adapter.GetProperty("samples").GetDouble(), Is.EqualTo(20));
        Assert.That(state.GetProperty("messages").GetProperty(RosTopics.JointStates).GetInt64(), Is.EqualTo(20));
        Assert.That(state.GetProperty("connections").GetProperty("websocket").GetProperty("open").GetInt32(), Is.EqualTo(1));
    }

    static void AssertBudget(JsonElement budget, double forwardMs)
    {
        double Of(string hop) => budget.GetProperty(hop).GetDouble();
        Assert.That(Of("plant"), Is.EqualTo(80).Within(20));
        Assert.That(Of("gateway"), Is.EqualTo(forwardMs).Within(0.01));
        Assert.That(Of("network"), Is.EqualTo(2));
        Assert.That(Of("queue"), Is.EqualTo(95 - Of("plant") - Of("gateway") - 2).Within(0.01));
        Assert.That(Of("render"), Is.EqualTo(12));
        Assert.That(Of("display"), Is.EqualTo(30));
    }

    [Test]
    public async Task State_LatencyBelowTheMedianAge_HasANegativeQueueSoThatTheHopsAddUp()
    {
        var clock = new StopwatchControlClock(Gateways.Start);
        await using var gateway = await Gateways.StartAsync(Gateways.Options(), clock);
        using var source = gateway.Hub.OpenSource();

        var budget = await BudgetAsync(gateway, source, clock, ["a"]);

        Assert.That(budget.GetProperty("plant").GetDouble(), Is.GreaterThan(80));
        Assert.That(
            new[] { "plant", "gateway", "network", "queue" }.Sum(hop => budget.GetProperty(hop).ValueKind == JsonValueKind.Number ? budget.GetProperty(hop).GetDouble() : 0),
            Is.EqualTo(50).Within(0.01));
    }

    [Test]
    public async Task State_SeveralRobots_LeavesOutTheHopsThatDependOnTheRobotOfTheHeadset()
    {
        var clock = new StopwatchControlClock(Gateways.Start);
        await using var gateway = await Gateways.StartAsync(Gateways.Options(), clock);
        using var source = gateway.Hub.OpenSource();

        var budget = await BudgetAsync(gateway, source, clock, ["a", "arm1/a"]);

        Assert.That(budget.GetProperty("plant").ValueKind, Is.EqualTo(JsonValueKind.Null));
        Assert.That(budget.GetProperty("queue").ValueKind, Is.EqualTo(JsonValueKind.Null));
        Assert.That(budget.GetProperty("network").GetDouble(), Is.EqualTo(2));
    }

    // Gets the latency budget of a headset with an L_app of 50 ms, while each joint has samples that are at least 80 ms old.
    static async Task<JsonElement> BudgetAsync(GatewayServer gateway, HubSource source, StopwatchControlClock clock, string[] joints)
    {
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates);
        foreach (var joint in joints)
            source.Publish(
                new JointStateMessage(clock.Now - TimeSpan.FromMilliseconds(80), [joint[(joint.IndexOf('/') + 1)..]], [1]), null,
                joint.Contains('/') ? joint[..joint.IndexOf('/')] : "");
        await Soon.BecomesAsync(() => gateway.Hub.Forwarding.Counts().Sum() > 0, "a sample is forwarded");
        source.Publish(RosTopics.Diagnostics, Diagnostics("goggles", ("rtt_ms", "4"), ("l_app_ms", "50"), ("l_visu_ms", "42"), ("render_ms", "12")));
        return (await StateAsync(gateway)).GetProperty("headsets")[0].GetProperty("budget_ms");
    }

    [Test]
    public async Task State_HeadsetReportsNumbersThatOverflow_IsServed()
    {
        await using var gateway = await Gateways.StartAsync();
        using var source = gateway.Hub.OpenSource();
        source.Publish(RosTopics.Diagnostics, Diagnostics(
            "goggles", ("rtt_ms", "-1.7e308"), ("l_app_ms", "1.7e308"), ("l_visu_ms", "1.7e308"), ("render_ms", "-1.7e308")));
        using var joints = gateway.Hub.OpenSource();
        joints.Publish(Gateways.State(1, "a"));

        var (status, text, _) = await GetAsync(gateway, "/operations/state");

        Assert.That(status, Is.EqualTo(HttpStatusCode.OK));
        var budget = JsonDocument.Parse(text).RootElement.GetProperty("headsets")[0].GetProperty("budget_ms");
        Assert.That(budget.GetProperty("display").ValueKind, Is.EqualTo(JsonValueKind.Null));
        Assert.That((await GetAsync(gateway, "/metrics")).Status, Is.EqualTo(HttpStatusCode.OK));
    }

    [Test]
    public async Task State_ClockNeverMeasured_OmitsItsNumbers()
    {
        await using var gateway = await Gateways.StartAsync();
        using var adapter = await PlantAdapterDouble.ConnectAsync(gateway, "press", (_, _) => null);
        await Soon.BecomesAsync(() => gateway.PlantClocks.All.Count == 1, "it is offered");

        var state = await StateAsync(gateway);

        foreach (var clock in new[] { state.GetProperty("clock"), state.GetProperty("plant_clocks")[0] })
        {
            Assert.That(clock.GetProperty("state").GetString(), Is.EqualTo("unsynchronised"));
            string[] numbers = ["error_bound_us", "estimated_error_us", "rtt_ms", "resolution_us", "skew_ppm", "drift_ppm", "offset_to_control_ms"];
            foreach (var number in numbers)
                Assert.That(clock.TryGetProperty(number, out _), Is.False, $"{number}: {clock}");
        }

        Assert.That((await GetAsync(gateway, "/metrics")).Text, Does.Not.Match(@"(?m)^nowpose_\w*clock_(error_bound|estimated_error|round_trip)"));
    }

    [Test]
    public async Task State_ClockMeasured_ContainsItsErrorAndBound()
    {
        await using var gateway = await Gateways.StartAsync();
        using var adapter = await PlantAdapterDouble.ConnectAsync(gateway, "press", new StopwatchControlClock(Gateways.Start));
        await Soon.BecomesAsync(() => gateway.Clock.Source == "press" && gateway.Clock.State == ClockState.Synchronised, "the clock is known");

        var state = await StateAsync(gateway);

        foreach (var clock in new[] { state.GetProperty("clock"), state.GetProperty("plant_clocks")[0] })
            Assert.That(
                clock.GetProperty("estimated_error_us").GetDouble(),
                Is.GreaterThan(0).And.LessThanOrEqualTo(clock.GetProperty("error_bound_us").GetDouble()));
        Assert.That(
            (await GetAsync(gateway, "/metrics")).Text, Does.Match(@"(?m)^nowpose_plant_clock_estimated_error_seconds\{clock=""press""[^}]*\} \S+"));
    }

    [Test]
    public async Task State_AdapterReportsALongReason_ContainsTheReason()
    {
        var untrusted = $"the server's certificate is not trusted; its thumbprint is {new string('a', 40)} (SHA-1), {new string('b', 64)} (SHA-256). "
            + $"If this is the certificate of your server, move /{new string('c', 240)}.der to /trusted, "
            + "or add plant.security.thumbprint to the configuration";
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SendAsync(RosbridgeWriter.Publish(
            RosTopics.Diagnostics, Diagnostics("plant/press", ("state", "refused"), ("reason", untrusted)), RosTimeForm.Sec));
        await client.RoundTripAsync();

        var reported = (await StateAsync(gateway)).GetProperty("adapters")[0];

        Assert.That(reported.GetProperty("reason").GetString(), Is.EqualTo(untrusted));
    }

    [Test]
    public async Task State_TextsTruncatedWithinACharacter_IsAnswered()
    {
        await using var gateway = await Gateways.StartAsync();
        using var source = gateway.Hub.OpenSource();
        foreach (var ahead in new[] { "", "x" })
            source.Publish(RosTopics.Diagnostics, Diagnostics(
                $"plant/{ahead}", ("reason", ahead + string.Concat(Enumerable.Repeat("\U0001F916", 1000)))));

        var reported = (await StateAsync(gateway)).GetProperty("adapters");

        Assert.That(reported.EnumerateArray().Select(adapter => adapter.GetProperty("reason").GetString()), Is.Not.Empty.And.All.Contains("…"));
    }

    [Test]
    public async Task State_GatewayWithTls_ContainsTheExpiryOfTheCertificate()
    {
        using var certificate = CertificateFiles.Generate();
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Certificate = certificate });
        using var http = new HttpClient(new SocketsHttpHandler
        {
            SslOptions = { RemoteCertificateValidationCallback = (_, shown, _, _) => gateway.Pin.Matches(shown) },
        });

        var text = await http.GetStringAsync(new Uri($"https://127.0.0.1:{gateway.WebSocketEndPoint.Port}/operations/state")).Bounded();

        Assert.That(
            JsonDocument.Parse(text).RootElement.GetProperty("certificate_expires_utc").GetDateTime(),
            Is.EqualTo(certificate.NotAfter.ToUniversalTime()));
    }

    [Test]
    public void State_NumberNotFinite_IsNull()
    {
        var text = JsonSerializer.Serialize(new { age = double.NaN, rate = (double?)double.PositiveInfinity, good = 1.5 }, StatusRoutes.Snake);

        Assert.That(text, Is.EqualTo("{\"age\":null,\"rate\":null,\"good\":1.5}"));
    }

    [Test]
    public async Task State_ThrottledClient_ItsForwardingTimesAreNotCounted()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates, throttleMs: 50);
        using var source = gateway.Hub.OpenSource();
        source.Publish(Gateways.State(1, "a"));
        await client.ReceiveAsync();

        Assert.That((await StateAsync(gateway)).TryGetProperty("forward_ms", out _), Is.False);
    }

    [Test]
    public async Task State_Requested_ContainsTheHostNameOfTheGateway()
    {
        await using var gateway = await Gateways.StartAsync();

        Assert.That((await StateAsync(gateway)).GetProperty("host").GetString(), Is.EqualTo(Environment.MachineName));
    }
}
