using System.Net;
using System.Net.Http.Headers;
using System.Text.Json;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Status;
using Nowpose.Headless.Tests.Gateway.Clock;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>The gateway's answers to monitoring.</summary>
public class StatusRoutesTests
{
    static readonly string[] OpenToAll = ["/healthz", "/readyz"];

    static async Task<(HttpStatusCode Status, string Text, string Type)> GetAsync(
        GatewayServer gateway, string path, string token = null, string host = null, HttpMethod method = null, string origin = null)
    {
        using var http = new HttpClient();
        using var request = new HttpRequestMessage(method ?? HttpMethod.Get, new Uri($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}{path}"));
        if (token != null) request.Headers.Authorization = new AuthenticationHeaderValue("Bearer", token);
        if (host != null) request.Headers.Host = host;
        if (origin != null) request.Headers.Add("Origin", origin);
        using var response = await http.SendAsync(request).Bounded();
        return (response.StatusCode, await response.Content.ReadAsStringAsync().Bounded(), response.Content.Headers.ContentType?.ToString());
    }

    static async Task<JsonElement> StateAsync(GatewayServer gateway) =>
        JsonDocument.Parse((await GetAsync(gateway, "/operations/state")).Text).RootElement;

    static DiagnosticsMessage Diagnostics(string name, params (string Key, string Value)[] values) =>
        new(Gateways.Start, name, [.. values.Select(pair => KeyValuePair.Create(pair.Key, pair.Value))]);

    [Test]
    public async Task State_JointOutsideTheLimitsOfTheDescription_IsNamed()
    {
        await using var gateway = await Gateways.StartAsync();
        using var source = gateway.Hub.OpenSource();
        source.TryDescribe(RobotFiles.LoadText("ur5"));
        var isNamed = false;

        for (var tries = 0; !isNamed && tries < 400; tries++)
        {
            source.TryPublish(new JointStateMessage(Gateways.Start, ["wrist_1_joint", "wrist_2_joint"], [-45, 1]));
            var sources = (await StateAsync(gateway)).GetProperty("sources").EnumerateArray();
            var named = sources.Single().GetProperty("beyond_limits").EnumerateArray().Select(joint => joint.GetString());
            isNamed = named.SequenceEqual(["wrist_1_joint"]);
        }

        Assert.That(isNamed, "within 400 samples, for its description is read meanwhile");
        Assert.That((await GetAsync(gateway, "/metrics")).Text, Does.Match("(?m)^nowpose_source_beyond_limits{.*} 1$"));
    }

    [Test]
    public async Task Ready_SourceStampsWithACorrectedSystemClock_IsNotReadyWithTheReason()
    {
        // One hour behind, as after a correction of the system clock that the gateway's own clock did not follow.
        var behind = new StopwatchControlClock(new ControlTime(DateTime.UtcNow - DateTime.UnixEpoch - TimeSpan.FromHours(1)));
        await using var gateway = await Gateways.StartAsync(clock: behind);
        using var source = await RawRosbridgeClient.ConnectAsync(gateway);
        Assert.That((await GetAsync(gateway, "/readyz")).Status, Is.EqualTo(HttpStatusCode.OK));

        var answer = default((HttpStatusCode Status, string Text, string Type));
        await Soon.BecomesAsync(
            () =>
            {
                var stamp = new ControlTime(DateTime.UtcNow - DateTime.UnixEpoch);
                source.SendAsync(RosbridgeWriter.PublishJointState(
                    RosTopics.JointStates, new JointStateMessage(stamp, ["a"], [0.5]), RosTimeForm.Sec)).GetAwaiter().GetResult();
                answer = GetAsync(gateway, "/readyz").GetAwaiter().GetResult();
                return answer.Status == HttpStatusCode.ServiceUnavailable && answer.Text.Contains("contradict", StringComparison.Ordinal);
            },
            "not ready");

        Assert.That(answer.Text, Does.StartWith("waiting").And.Contain("stamps").And.Contain("--own-clock system"));
        Assert.That((await StateAsync(gateway)).GetProperty("clock").GetProperty("warning").GetString(), Does.Contain("system clock"));
        Assert.That((await GetAsync(gateway, "/metrics")).Text, Does.Contain("\nnowpose_clock_warning 1\n"));
    }

    [Test]
    public async Task Ready_SystemClockServedAndSourceStampsWithIt_IsReady()
    {
        await using var gateway = await Gateways.StartAsync(clock: new SystemControlClock());
        using var source = await RawRosbridgeClient.ConnectAsync(gateway);

        for (var i = 0; i < 50; i++)
        {
            var stamp = new ControlTime(DateTime.UtcNow - DateTime.UnixEpoch);
            await source.SendAsync(RosbridgeWriter.PublishJointState(
                RosTopics.JointStates, new JointStateMessage(stamp, ["a"], [0.5]), RosTimeForm.Sec));
        }

        await source.RoundTripAsync();
        Assert.That(gateway.Drops.Total, Is.Zero);
        Assert.That((await GetAsync(gateway, "/readyz")).Text, Is.EqualTo("ready\n"));
    }

    [TestCase("/operations")]
    [TestCase("/operations/state")]
    [TestCase("/metrics")]
    [TestCase("/vlc")]
    [TestCase("/")]
    public async Task Origin_Foreign_ReceivesOnlyTheHealthState(string path)
    {
        await using var gateway = await Gateways.StartAsync();

        var (status, text, _) = await GetAsync(gateway, path, origin: "http://evil.example");

        Assert.That(status, Is.EqualTo(HttpStatusCode.Forbidden), text);
        foreach (var word in OpenToAll)
            Assert.That((await GetAsync(gateway, word, origin: "http://evil.example")).Text, Does.Match("^(live|ready|waiting)\n$"));
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
            source.TryPublish(new JointStateMessage(clock.Now - TimeSpan.FromMilliseconds(80), ["a", "b"], [1, 2]));
            await client.ReceiveAsync();
        }
        // The client may receive the last message before the gateway records its forwarding time.
        await Soon.BecomesAsync(() => gateway.Hub.Forwarding.Counts().Sum() == 20, "all are counted");
        source.Publish(Diagnostics(
            "goggles", ("state", "synchronised"), ("rtt_ms", "4"), ("l_app_ms", "95"), ("render_ms", "12"), ("l_visu_ms", "42"), ("budget_ms", "x")));
        source.Publish(Diagnostics("plant/press", ("kind", "opcua"), ("state", "connected"), ("samples", "20")));

        var state = await StateAsync(gateway);

        Assert.That(state.GetProperty("cell").GetString(), Is.EqualTo("press"));
        Assert.That(state.GetProperty("role").GetString(), Is.EqualTo("operator"), "a browser on this machine may do all");
        Assert.That(state.GetProperty("control_time_s").GetDouble(), Is.EqualTo(clock.Now.SinceEpoch.TotalSeconds).Within(20));
        var joints = state.GetProperty("sources")[0];
        Assert.That(joints.GetProperty("joints").EnumerateArray().Select(name => name.GetString()), Is.EqualTo(new[] { "a", "b" }));
        Assert.That(joints.GetProperty("age_ms").GetProperty("p50").GetDouble(), Is.EqualTo(80).Within(20));
        var headset = state.GetProperty("headsets")[0];
        Assert.That(headset.GetProperty("name").GetString(), Is.EqualTo("goggles"));
        Assert.That(headset.GetProperty("l_app_ms").GetDouble(), Is.EqualTo(95), "numbers are numbers");
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
        Assert.That(Of("queue"), Is.EqualTo(Math.Max(0, 95 - Of("plant") - Of("gateway") - 2)).Within(0.01));
        Assert.That(Of("render"), Is.EqualTo(12));
        Assert.That(Of("display"), Is.EqualTo(30));
    }

    [Test]
    public async Task State_HeadsetReportsTheLargestNumbers_IsAnswered()
    {
        await using var gateway = await Gateways.StartAsync();
        using var source = gateway.Hub.OpenSource();
        source.Publish(Diagnostics("goggles", ("rtt_ms", "-1.7e308"), ("l_app_ms", "1.7e308"), ("l_visu_ms", "1.7e308"), ("render_ms", "-1.7e308")));
        using var joints = gateway.Hub.OpenSource();
        joints.TryPublish(Gateways.State(1, "a"));

        var (status, text, _) = await GetAsync(gateway, "/operations/state");

        Assert.That(status, Is.EqualTo(HttpStatusCode.OK));
        var budget = JsonDocument.Parse(text).RootElement.GetProperty("headsets")[0].GetProperty("budget_ms");
        Assert.That(budget.GetProperty("display").ValueKind, Is.EqualTo(JsonValueKind.Null));
        Assert.That((await GetAsync(gateway, "/metrics")).Status, Is.EqualTo(HttpStatusCode.OK));
    }

    [Test]
    public async Task State_ClockNeverAnswered_OmitsItsNumbers()
    {
        await using var gateway = await Gateways.StartAsync();
        using var adapter = await PlantAdapterDouble.ConnectAsync(gateway, "press", (_, _) => null);
        await Soon.BecomesAsync(() => gateway.PlantClocks.All.Count == 1, "it is offered");

        var state = await StateAsync(gateway);

        foreach (var clock in new[] { state.GetProperty("clock"), state.GetProperty("plant_clocks")[0] })
        {
            Assert.That(clock.GetProperty("state").GetString(), Is.EqualTo("unsynchronised"));
            foreach (var number in new[] { "error_bound_us", "estimated_error_us", "rtt_ms", "resolution_us", "skew_ppm", "drift_ppm", "offset_to_control_ms" })
                Assert.That(clock.TryGetProperty(number, out _), Is.False, $"{number}: {clock}");
        }

        Assert.That((await GetAsync(gateway, "/metrics")).Text, Does.Not.Match(@"(?m)^nowpose_\w*clock_(error_bound|estimated_error|round_trip)"));
    }

    [Test]
    public async Task State_ClockMeasured_ContainsEstimatedErrorAndBound()
    {
        await using var gateway = await Gateways.StartAsync();
        using var adapter = await PlantAdapterDouble.ConnectAsync(gateway, "press", new StopwatchControlClock(Gateways.Start));
        await Soon.BecomesAsync(() => gateway.Clock.Source == "press" && gateway.Clock.State == ClockState.Synchronised, "the clock is known");

        var state = await StateAsync(gateway);

        foreach (var clock in new[] { state.GetProperty("clock"), state.GetProperty("plant_clocks")[0] })
            Assert.That(
                clock.GetProperty("estimated_error_us").GetDouble(), Is.GreaterThan(0).And.LessThanOrEqualTo(clock.GetProperty("error_bound_us").GetDouble()));
        Assert.That((await GetAsync(gateway, "/metrics")).Text, Does.Match(@"(?m)^nowpose_plant_clock_estimated_error_seconds\{clock=""press""[^}]*\} \S+"));
    }

    [Test]
    public async Task State_AdapterWithALongReason_ContainsIt()
    {
        var untrusted = $"the server's certificate is not trusted; its thumbprint is {new string('a', 40)} (SHA-1), {new string('b', 64)} (SHA-256). "
            + $"If this is the certificate of your server, move /{new string('c', 240)}.der to /trusted, "
            + "or add plant.security.thumbprint to the configuration";
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SendAsync(RosbridgeWriter.PublishDiagnostics(
            RosTopics.Diagnostics, Diagnostics("plant/press", ("state", "refused"), ("reason", untrusted)), RosTimeForm.Sec));
        await client.RoundTripAsync();

        var told = (await StateAsync(gateway)).GetProperty("adapters")[0];

        Assert.That(told.GetProperty("reason").GetString(), Is.EqualTo(untrusted));
    }

    [Test]
    public async Task State_TextsCutWithinACharacter_IsAnswered()
    {
        await using var gateway = await Gateways.StartAsync();
        using var source = gateway.Hub.OpenSource();
        foreach (var ahead in new[] { "", "x" })
            source.Publish(Diagnostics($"plant/{ahead}", ("reason", ahead + string.Concat(Enumerable.Repeat("\U0001F916", 1000)))));

        var told = (await StateAsync(gateway)).GetProperty("adapters");

        Assert.That(told.EnumerateArray().Select(adapter => adapter.GetProperty("reason").GetString()), Has.All.Contains("…"));
    }

    [Test]
    public async Task State_OverTls_ContainsTheExpiryOfTheCertificate()
    {
        using var certificate = CertificateFiles.Generate();
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Certificate = certificate });
        using var http = new HttpClient(new SocketsHttpHandler
        {
            SslOptions = { RemoteCertificateValidationCallback = (_, shown, _, _) => gateway.Pin.Matches(shown) },
        });

        var text = await http.GetStringAsync(new Uri($"https://127.0.0.1:{gateway.WebSocketEndPoint.Port}/operations/state")).Bounded();

        Assert.That(
            JsonDocument.Parse(text).RootElement.GetProperty("certificate_expires_utc").GetDateTime(), Is.EqualTo(certificate.NotAfter.ToUniversalTime()));
    }

    [Test]
    public void State_NumberNotFinite_IsNull()
    {
        var text = JsonSerializer.Serialize(new { age = double.NaN, rate = (double?)double.PositiveInfinity, good = 1.5 }, StatusRoutes.Snake);

        Assert.That(text, Is.EqualTo("{\"age\":null,\"rate\":null,\"good\":1.5}"));
    }

    [Test]
    public async Task State_ForwardingOfAThrottledClient_IsNotCounted()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates, throttleMs: 50);
        using var source = gateway.Hub.OpenSource();
        source.TryPublish(Gateways.State(1, "a"));
        await client.ReceiveAsync();

        Assert.That((await StateAsync(gateway)).TryGetProperty("forward_ms", out _), Is.False);
    }

    [TestCase("/operations/state", null, HttpStatusCode.Unauthorized)]
    [TestCase("/operations/state", "guess", HttpStatusCode.Unauthorized)]
    [TestCase("/operations/state", Gateways.ObserverToken, HttpStatusCode.OK)]
    [TestCase("/metrics", null, HttpStatusCode.Unauthorized)]
    [TestCase("/metrics", Gateways.ObserverToken, HttpStatusCode.OK)]
    [TestCase("/healthz", null, HttpStatusCode.OK)]
    [TestCase("/readyz", null, HttpStatusCode.OK)]
    public async Task Routes_TokenRequiredButMissing_ReturnOnlyHealth(string path, string token, HttpStatusCode expected)
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });

        var (status, text, _) = await GetAsync(gateway, path, token);

        Assert.That(status, Is.EqualTo(expected));
        if (OpenToAll.Contains(path)) Assert.That(text.Trim(), Is.EqualTo("live").Or.EqualTo("ready"));
    }

    [TestCase("/operations/state", "evil.example", HttpStatusCode.Forbidden)]
    [TestCase("/metrics", "evil.example", HttpStatusCode.Forbidden)]
    [TestCase("/metrics", "localhost", HttpStatusCode.OK)]
    public async Task Routes_ReboundHostName_AreRefused(string path, string host, HttpStatusCode expected)
    {
        await using var gateway = await Gateways.StartAsync();

        Assert.That((await GetAsync(gateway, path, host: host)).Status, Is.EqualTo(expected));
    }

    [TestCase("/operations/state")]
    [TestCase("/metrics")]
    [TestCase("/healthz")]
    [TestCase("/readyz")]
    public async Task Routes_OtherMethods_AreRefused(string path)
    {
        await using var gateway = await Gateways.StartAsync();

        Assert.That((await GetAsync(gateway, path, method: HttpMethod.Post)).Status, Is.EqualTo(HttpStatusCode.MethodNotAllowed));
    }

    [Test]
    public async Task Ready_ClockUnsynchronised_IsNotReady()
    {
        await using var gateway = await Gateways.StartAsync(clock: new StopwatchControlClock(Gateways.Start) { IsSynchronised = false });

        var (status, text, _) = await GetAsync(gateway, "/readyz");

        Assert.That(status, Is.EqualTo(HttpStatusCode.ServiceUnavailable));
        Assert.That(text, Does.StartWith("waiting\nthe gateway's own control clock is not served"));
        Assert.That((await GetAsync(gateway, "/healthz")).Status, Is.EqualTo(HttpStatusCode.OK), "it lives all the same");
    }

    [Test]
    public async Task Ready_SourcesExpected_IsNotReadyBeforeTheFirst()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { ExpectsSources = true });
        Assert.That((await GetAsync(gateway, "/readyz")).Status, Is.EqualTo(HttpStatusCode.ServiceUnavailable));

        using var source = gateway.Hub.OpenSource();
        source.TryPublish(Gateways.State(1, "a"));

        Assert.That((await GetAsync(gateway, "/readyz")).Status, Is.EqualTo(HttpStatusCode.OK));
    }
}
