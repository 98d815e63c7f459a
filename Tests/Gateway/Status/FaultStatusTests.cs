using System.Net;
using System.Net.Http.Headers;
using System.Text.Json;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Status.Events;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Network;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>Faults as a gateway shows them: in its state, in /readyz, in the metrics and in the list of events.</summary>
public class FaultStatusTests
{
    readonly List<string> _log = [];
    SteppedTime _time;
    GatewayServer _gateway;
    HubSource _source;

    async Task StartAsync(Func<GatewayOptions, GatewayOptions> with = null, IControlClock clock = null)
    {
        var options = Gateways.Options() with { Time = _time };
        _gateway = await GatewayServer.StartAsync(with?.Invoke(options) ?? options, clock ?? new StopwatchControlClock(Gateways.Start), Log).Bounded();
        _source = _gateway.Hub.OpenSource();
    }

    [SetUp]
    public void SetUp()
    {
        _time = new SteppedTime();
        _log.Clear();
    }

    [TearDown]
    public async Task Close()
    {
        _source?.Dispose();
        if (_gateway != null) await _gateway.DisposeAsync();
        (_source, _gateway) = (null, null);
    }

    void Log(string line)
    {
        lock (_log) _log.Add(line);
    }

    async Task<(HttpStatusCode Status, string Text, HttpContentHeaders Headers)> GetAsync(string path, string token = null)
    {
        using var http = new HttpClient();
        using var request = new HttpRequestMessage(HttpMethod.Get, new Uri($"http://127.0.0.1:{_gateway.WebSocketEndPoint.Port}{path}"));
        if (token != null) request.Headers.Authorization = new AuthenticationHeaderValue("Bearer", token);
        using var response = await http.SendAsync(request).Bounded();
        return (response.StatusCode, await response.Content.ReadAsStringAsync().Bounded(), response.Content.Headers);
    }

    async Task<JsonElement> StateAsync() => JsonDocument.Parse((await GetAsync("/operations/state")).Text).RootElement;

    async Task<string[]> ReadyAsync(HttpStatusCode expected)
    {
        var (status, text, _) = await GetAsync("/readyz");
        Assert.That(status, Is.EqualTo(expected), text);
        return text.TrimEnd('\n').Split('\n');
    }

    void Publish(params string[] joints) => _source.TryPublish(Gateways.State(1, joints));

    void Report(string name, params (string Key, string Value)[] values) =>
        _source.Publish(new DiagnosticsMessage(Gateways.Start, name, [.. values.Select(pair => KeyValuePair.Create(pair.Key, pair.Value))]));

    string Since(double secondsAgo = 0) =>
        ((_time.GetUtcNow() - TimeSpan.FromSeconds(secondsAgo)).ToUnixTimeMilliseconds() / 1000.0).ToString("0.000", System.Globalization.CultureInfo.InvariantCulture);

    async Task<JsonElement> EventAsync(string kind, string which) =>
        (await StateAsync()).GetProperty("events").EnumerateArray().FirstOrDefault(
            one => one.GetProperty("kind").GetString() == kind && one.GetProperty("which").GetString() == which);

    // The gateway updates the list several times per second.
    Task BeginsAsync(string kind, string which) => Soon.BecomesAsync(
        () => EventAsync(kind, which).Result.ValueKind == JsonValueKind.Object, $"{kind} {which} begins");

    Task EndsAsync(string kind, string which) => Soon.BecomesAsync(
        () => EventAsync(kind, which).Result is { ValueKind: JsonValueKind.Object } one && one.TryGetProperty("until_utc", out _), $"{kind} {which} ends");

    [Test]
    public async Task Joint_SamplesStop_IsReportedEverywhereWithinTwoSecondsAndRecoversImmediately()
    {
        await StartAsync();
        Publish("a", "b");
        Assert.That(await ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));

        _time.Advance(TimeSpan.FromSeconds(1));
        Publish("b");
        _time.Advance(TimeSpan.FromSeconds(1));

        var lines = await ReadyAsync(HttpStatusCode.ServiceUnavailable);
        Assert.That(lines, Has.Length.EqualTo(2), "the other joint goes on");
        Assert.That(lines[0], Is.EqualTo("waiting"));
        Assert.That(lines[1], Does.StartWith("joint a (gateway) is stale: "));
        var state = await StateAsync();
        var joint = state.GetProperty("joints")[0];
        Assert.That(joint.GetProperty("state").GetString(), Is.EqualTo("stale"));
        Assert.That(joint.GetProperty("since_utc").GetString(), Is.EqualTo("2026-11-20T12:00:00.000Z"));
        Assert.That(joint.GetProperty("reason").GetString(), Is.Not.Empty);
        Assert.That(state.GetProperty("joints")[1].GetProperty("state").GetString(), Is.EqualTo("live"));
        Assert.That(state.GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("error"));
        Assert.That(state.GetProperty("status").GetProperty("text").GetString(), Does.Contain("joint a"));
        var metrics = (await GetAsync("/metrics")).Text;
        Assert.That(metrics, Does.Contain("nowpose_joint_state{joint=\"a\",source=\"gateway\",state=\"stale\"} 1"));
        Assert.That(metrics, Does.Contain("nowpose_ready 0"));
        await BeginsAsync("joint", "a (gateway)");

        Publish("a");

        Assert.That(await ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));
        Assert.That((await StateAsync()).GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("ok"));
        await EndsAsync("joint", "a (gateway)");
        lock (_log) Assert.That(_log.Count(line => line.Contains("joint a (gateway) is stale")), Is.EqualTo(2), string.Join('\n', _log));
    }

    [TestCase("refused", "is refused", "Check the values that its source sends.")]
    [TestCase("missing", "is missing", "Check that the plant offers the joint's value and that the plant's configuration names it correctly.")]
    [TestCase("fault", "is in fault", "Check the plant and its connection.")]
    public async Task Joint_AdapterReportsAFault_IsNamedWithReasonSinceAndRemedy(string word, string what, string remedy)
    {
        await StartAsync(options => options with { ExpectsSources = true });
        Publish("a", "b");

        Report("adapter/press", ("state", "connected"), ("joint/a", $"{word} {Since(90)} the node ns=2;s=Axis1 is gone"), ("joint/b", $"live {Since()} "));

        Assert.That(await ReadyAsync(HttpStatusCode.ServiceUnavailable), Is.EqualTo(new[]
        {
            "waiting", $"joint a (press) {what}: the node ns=2;s=Axis1 is gone (since 2026-11-20 11:58:30 UTC). {remedy}",
        }));
        var joints = (await StateAsync()).GetProperty("joints");
        Assert.That(joints.GetArrayLength(), Is.EqualTo(2));
        Assert.That(joints[0].GetProperty("source").GetString(), Is.EqualTo("press"));
        Assert.That(joints[0].GetProperty("since_utc").GetString(), Is.EqualTo("2026-11-20T11:58:30.000Z"));
        Assert.That(joints[1].GetProperty("state").GetString(), Is.EqualTo("live"));
        Assert.That((await GetAsync("/metrics")).Text, Does.Contain($"nowpose_joint_state{{joint=\"a\",source=\"press\",state=\"{word}\"}} 1"));
    }

    [Test]
    public async Task Joint_AtRest_IsReady()
    {
        await StartAsync(options => options with { ExpectsSources = true });
        Publish("a");
        _time.Advance(TimeSpan.FromSeconds(100));

        Report("adapter/press", ("state", "connected"), ("joint/a", $"rest {Since(99)} assumed at rest"));

        Assert.That(await ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));
        Assert.That((await StateAsync()).GetProperty("joints")[0].GetProperty("state").GetString(), Is.EqualTo("rest"));
        Assert.That((await StateAsync()).GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("ok"));
    }

    [Test]
    public async Task Joint_RestUncertain_IsAWarningUntilItMoves()
    {
        await StartAsync(options => options with { ExpectsSources = true });
        Publish("a");

        Report("adapter/press", ("state", "connected"), ("joint/a", $"rest {Since(3)} assumed at rest"), ("uncertain/a", "the stop itself was not observed"));

        await BeginsAsync("joint", "a (press)");
        var status = (await StateAsync()).GetProperty("status");
        Assert.That((await StateAsync()).GetProperty("joints")[0].GetProperty("uncertain").GetString(), Is.EqualTo("the stop itself was not observed"));
        Assert.That((await GetAsync("/metrics")).Text, Does.Contain("nowpose_joint_rest_uncertain{joint=\"a\",source=\"press\"} 1"));
        Assert.That(status.GetProperty("level").GetString(), Is.EqualTo("warning"));
        Assert.That(status.GetProperty("text").GetString(), Is.EqualTo(
            "joint a (press) may not be at rest: the stop itself was not observed (since 2026-11-20 11:59:57 UTC). "
                + "Check that the joint is at rest; if it is, set its max_deceleration in the plant's configuration."));
        Assert.That(await ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));

        Report("adapter/press", ("state", "connected"), ("joint/a", $"live {Since()} "));

        await EndsAsync("joint", "a (press)");
        Assert.That((await StateAsync()).GetProperty("joints")[0].TryGetProperty("uncertain", out _), Is.False);
        Assert.That((await GetAsync("/metrics")).Text, Does.Contain("nowpose_joint_rest_uncertain{joint=\"a\",source=\"press\"} 0"));
    }

    [Test]
    public async Task Joint_RestUncertainWithAdapterRemedy_HasOnlyThatRemedy()
    {
        await StartAsync();
        Publish("a");

        Report("adapter/press", ("state", "connected"), ("joint/a", $"rest {Since(3)} assumed at rest"), ("uncertain/a", "nothing confirms it; set silence"));

        await BeginsAsync("joint", "a (press)");
        Assert.That((await StateAsync()).GetProperty("status").GetProperty("text").GetString(), Does.EndWith("UTC). Check that the joint is at rest."));
    }

    [TestCase(null, "error")]
    [TestCase("03F3", "error")]
    [TestCase("03E8", "ok")]
    public async Task Joint_ClientDisconnected_StaysInFaultUnlessClosedNormally(string close, string level)
    {
        await StartAsync();
        using var client = await RawWebSocket.OpenAsync(_gateway);
        await client.SendTextAsync(Gateways.StateText(1));
        await Soon.BecomesAsync(() => StateAsync().Result.GetProperty("joints").GetArrayLength() == 1, "it is published");

        if (close != null) await client.SendFrameAsync(RawWebSocket.Close, Convert.FromHexString(close));
        client.EndSending();
        await Soon.BecomesAsync(() => _gateway.WebSocketConnections.Open == 0, "the connection is over");
        _time.Advance(TimeSpan.FromHours(30));

        var state = await StateAsync();
        Assert.That(state.GetProperty("status").GetProperty("level").GetString(), Is.EqualTo(level), state.GetRawText());
        Assert.That(state.GetProperty("joints").GetArrayLength(), Is.EqualTo(level == "ok" ? 0 : 1));
    }

    [Test]
    public async Task JointStatus_Subscribed_ContainsTheJointsThatAreNotLive()
    {
        await StartAsync();
        Publish("a", "b");
        Report("adapter/press", ("state", "connected"), ("joint/a", $"refused {Since(5)} status Bad"), ("joint/b", $"live {Since()} "));
        using var client = await RawRosbridgeClient.ConnectAsync(_gateway);
        await client.SubscribeAsync(RosTopics.JointStatus, "diagnostic_msgs/DiagnosticArray");

        JsonElement told;
        do told = JsonDocument.Parse(await client.ReceiveTextAsync()).RootElement.GetProperty("msg").GetProperty("status")[0];
        while (told.GetProperty("values").GetArrayLength() == 0);

        Assert.That(told.GetProperty("hardware_id").GetString(), Is.EqualTo("gateway"));
        var value = told.GetProperty("values").EnumerateArray().Single();
        Assert.That(value.GetProperty("key").GetString(), Is.EqualTo("a"));
        var words = value.GetProperty("value").GetString().Split(' ', 3);
        Assert.That((words[0], words[2]), Is.EqualTo(("refused", "status Bad")));
        var since = double.Parse(words[1], System.Globalization.CultureInfo.InvariantCulture);
        Assert.That(since, Is.InRange(Gateways.Start.SinceEpoch.TotalSeconds - 5.01, _gateway.Clock.Now.SinceEpoch.TotalSeconds - 4.9), "on the control clock");
    }

    [Test]
    public async Task Observer_WithTheNameOfAnAdapter_IsRefused()
    {
        await StartAsync(options => options with { Tokens = Gateways.Tokens });
        using var client = await RawRosbridgeClient.ConnectAsync(
            _gateway, set => set.SetRequestHeader("Authorization", $"Bearer {Gateways.ObserverToken}"));

        await client.SendAsync(RosbridgeWriter.PublishDiagnostics(
            RosTopics.Diagnostics, new DiagnosticsMessage(default, "adapter/press", [KeyValuePair.Create("joint/a", $"fault {Since()} made up")]), RosTimeForm.Sec));

        Assert.That((await client.ReceiveAsync()).Text, Does.Contain("NotAllowed"));
        Assert.That(await ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));
    }

    [Test]
    public async Task Adapter_NotConnectedThenSilent_AddsTwoEvents()
    {
        await StartAsync();
        _time.Advance(EventList.StartGrace);
        Report("adapter/press", ("state", "refused"), ("reason", "the certificate is not trusted"));
        await BeginsAsync("adapter", "press");
        Assert.That((await EventAsync("adapter", "press")).GetProperty("reason").GetString(), Is.EqualTo("refused: the certificate is not trusted"));

        _time.Advance(TimeSpan.FromMinutes(5));

        await Soon.BecomesAsync(() => EventAsync("adapter", "press").Result.GetProperty("what").GetString() == "does not report", "it is silent");
        Assert.That((await StateAsync()).GetProperty("adapters").GetArrayLength(), Is.EqualTo(1), "an adapter that is gone stays in the state");
    }

    [Test]
    public async Task Adapters_OneOfTwoNeverReports_GatewayIsNotReady()
    {
        await StartAsync(options => options with { ExpectsSources = true });
        var lathe = new AdapterState("lathe", null, "status 1");
        _gateway.Expect([() => new AdapterState("press", TimeSpan.FromSeconds(10), null), () => lathe]);
        Report("plant/press", ("state", "connected"), ("samples", "7"), ("joint/a", $"live {Since()} "));
        Publish("a");
        await BeginsAsync("adapter", "lathe");
        string[] expected =
        [
            "waiting",
            "adapter lathe does not report: its program ended with status 1 and is started again (since 2026-11-20 12:00:00 UTC). "
                + "Read its lines in the gateway's log.",
        ];

        Assert.That(await ReadyAsync(HttpStatusCode.ServiceUnavailable), Is.EqualTo(expected));
        lathe = lathe with { RunTime = TimeSpan.FromSeconds(0.2) };
        Assert.That(await ReadyAsync(HttpStatusCode.ServiceUnavailable), Is.EqualTo(expected), "it runs, but has not reported");
        Assert.That((await StateAsync()).GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("error"));

        Report("plant/lathe", ("state", "connected"), ("samples", "0"));
        // Both reports come from one source here, which gets the name of the last report.
        Report("plant/press", ("state", "connected"), ("samples", "7"), ("joint/a", $"live {Since()} "));

        Assert.That(await ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));
        await EndsAsync("adapter", "lathe");
    }

    [Test]
    public async Task Start_PlantConnectsWithinTheGracePeriod_AddsNoEvent()
    {
        await StartAsync(options => options with { ExpectsSources = true }, new StopwatchControlClock(Gateways.Start) { IsSynchronised = false });
        Report("adapter/press", ("state", "connecting"), ("samples", "0"), ("joint/a", $"missing {Since()} no value yet"));
        Report("adapter/lathe", ("state", "waiting"), ("samples", "7"));
        await BeginsAsync("adapter", "lathe");

        Assert.That(
            (await StateAsync()).GetProperty("events").EnumerateArray().Select(one => one.GetProperty("which").GetString()), Is.EqualTo(new[] { "lathe" }),
            "an adapter that has published samples was connected before");
        Assert.That(await ReadyAsync(HttpStatusCode.ServiceUnavailable), Has.Length.EqualTo(3), "the clock and the joint");
        Assert.That((await StateAsync()).GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("error"));

        Report("adapter/press", ("state", "connected"), ("samples", "1"), ("joint/a", $"live {Since()} "));
        Publish("a");
        _time.Advance(EventList.StartGrace);
        await BeginsAsync("clock", "own");

        Assert.That(
            (await StateAsync()).GetProperty("events").EnumerateArray().Select(one => one.GetProperty("kind").GetString()), Does.Not.Contain("source"));
        Assert.That(Logged("is missing"), Is.False);
        Assert.That(Logged("adapter press is not connected"), Is.False);
    }

    [Test]
    public async Task Clock_NotServed_AddsAnEventAndAReason()
    {
        await StartAsync(clock: new StopwatchControlClock(Gateways.Start) { IsSynchronised = false });

        Assert.That(await ReadyAsync(HttpStatusCode.ServiceUnavailable), Is.EqualTo(new[]
        {
            "waiting", "the gateway's own control clock is not served to headsets: its state is converging (since 2026-11-20 12:00:00 UTC)",
        }));
        _time.Advance(EventList.StartGrace);
        await BeginsAsync("clock", "own");
    }

    [Test]
    public async Task Headset_NotCurrentThenLost_AddsTwoEventsAndNoReason()
    {
        await StartAsync();
        Report("goggles", ("pose", "incomplete"), ("missing_joints", "a,b"));
        await BeginsAsync("headset", "goggles");
        Assert.That((await EventAsync("headset", "goggles")).GetProperty("reason").GetString(), Does.Contain("a,b"));
        Assert.That((await StateAsync()).GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("warning"));
        Assert.That(await ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }), "other headsets can be served");

        Report("goggles", ("pose", "coarse"));
        await EndsAsync("headset", "goggles");
        _time.Advance(TimeSpan.FromSeconds(4));

        await Soon.BecomesAsync(() => EventAsync("headset", "goggles").Result.GetProperty("what").GetString() == "is lost", "it is lost");
    }

    [TestCase("held", "a", "the pose is held; missing joints: a. Check the sources of these joints.")]
    [TestCase("incomplete", "a", "the pose is incomplete; missing joints: a. Check the sources of these joints.")]
    [TestCase("held", "", "the pose is held. Check that samples reach the headset in time.")]
    public async Task Headset_PoseNotCurrent_RemedyNamesTheCause(string pose, string missing, string expected)
    {
        await StartAsync();

        Report("goggles", ("pose", pose), ("missing_joints", missing));

        await BeginsAsync("headset", "goggles");
        Assert.That((await EventAsync("headset", "goggles")).GetProperty("text").GetString(), Is.EqualTo($"headset goggles shows no current pose: {expected}"));
    }

    [Test]
    public async Task Headset_LinkDisposedWhileReceiving_IsNotLost()
    {
        await StartAsync();
        var settings = new ConnectionSettings("127.0.0.1", webSocketPort: _gateway.WebSocketEndPoint.Port);
        using var link = new ClientWebSocketLink(settings, new StopwatchHeadsetClock());
        await link.OpenAsync(CancellationToken.None).Bounded();
        await link.SendAsync(
            RosbridgeWriter.PublishDiagnostics(
                RosTopics.Diagnostics, new DiagnosticsMessage(Gateways.Start, "goggles", [KeyValuePair.Create("pose", "current")]), RosTimeForm.Sec),
            CancellationToken.None).Bounded();
        await Soon.BecomesAsync(() => StateAsync().Result.GetProperty("headsets").GetArrayLength() == 1, "it is known");
        using var stop = new CancellationTokenSource();
        var receiving = link.ReceiveAsync(_ => { }, stop.Token);

        await stop.CancelAsync();
        Assert.That(async () => await receiving.Bounded(), Throws.InstanceOf<OperationCanceledException>());
        link.Dispose();

        await Soon.BecomesAsync(() => StateAsync().Result.GetProperty("headsets").GetArrayLength() == 0, "it has left");
    }

    [Test]
    public async Task Source_SecondForAJoint_AddsAnEventThatEnds()
    {
        await StartAsync();
        Publish("a");
        using var second = _gateway.Hub.OpenSource();
        second.Name = "copy";

        Assert.That(second.TryPublish(Gateways.State(1, "a")), Is.EqualTo("a"));

        await BeginsAsync("source", "copy of joint a");
        _time.Advance(TimeSpan.FromSeconds(6));
        await EndsAsync("source", "copy of joint a");
    }

    [Test]
    public async Task Certificate_AboutToExpire_AddsAnEvent()
    {
        using var certificate = CertificateFiles.Generate();
        _time.Advance(certificate.NotAfter.ToUniversalTime() - TimeSpan.FromDays(3) - _time.GetUtcNow());
        await StartAsync(options => options with { Certificate = certificate });

        await Soon.BecomesAsync(() => Logged("the gateway's certificate is about to expire"), "it is in the log");
        Assert.That(Logged("has expired"), Is.False);
        _time.Advance(TimeSpan.FromDays(4));
        await Soon.BecomesAsync(() => Logged("the gateway's certificate has expired"), "it is in the log");
    }

    bool Logged(string part)
    {
        lock (_log) return _log.Exists(line => line.Contains(part, StringComparison.Ordinal));
    }

    [TestCase(null, HttpStatusCode.Unauthorized)]
    [TestCase(Gateways.ObserverToken, HttpStatusCode.OK)]
    public async Task Events_Downloaded_RequireTheRightToReadTheState(string token, HttpStatusCode expected)
    {
        await StartAsync(options => options with { Tokens = Gateways.Tokens });

        Assert.That((await GetAsync("/operations/events", token)).Status, Is.EqualTo(expected));
    }

    [Test]
    public async Task Events_Downloaded_AreJsonOrCsv()
    {
        await StartAsync();
        Publish("a");
        _time.Advance(TimeSpan.FromSeconds(2));
        await BeginsAsync("joint", "a (gateway)");

        var (_, json, headers) = await GetAsync("/operations/events");
        Assert.That(JsonDocument.Parse(json).RootElement[0].GetProperty("which").GetString(), Is.EqualTo("a (gateway)"));
        Assert.That(headers.ContentDisposition.DispositionType, Is.EqualTo("attachment"));
        var (_, csv, type) = await GetAsync("/operations/events?format=csv");
        Assert.That(csv.Split("\r\n")[1], Does.StartWith("1,\"joint\",\"a (gateway)\",\"is stale\",").And.EndsWith(". Check that its source runs and reaches the gateway.\""));
        Assert.That(type.ContentType.MediaType, Is.EqualTo("text/csv"));
        Assert.That((await GetAsync("/operations/events?format=xml")).Status, Is.EqualTo(HttpStatusCode.BadRequest));
    }

    [TestCase("null", 5000, "position of joint b is null (NotFinite)")]
    [TestCase("NaN", 5000, "position of joint b is NaN (NotFinite)")]
    [TestCase("\"1\"", 5000, "position of joint b is \"1\" (WrongType)")]
    [TestCase("1.5", 50000, "the time stamp is later than the control time (StampInFuture)")]
    public async Task Joints_SourceWithInvalidSamples_AreRefusedWithTheJointsName(string position, int seconds, string reason)
    {
        await StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(_gateway);
        await client.SendAsync(RosbridgeWriter.PublishJointState(RosTopics.JointStates, Gateways.State(1, "a", "b"), RosTimeForm.Sec));
        await Soon.BecomesAsync(() => StateAsync().Result.GetProperty("joints").GetArrayLength() == 2, "both joints are known");
        _time.Advance(TimeSpan.FromSeconds(2));

        await client.SendAsync("{\"op\":\"publish\",\"topic\":\"/joint_states\",\"msg\":{\"header\":{\"stamp\":{\"sec\":" + seconds
            + ",\"nanosec\":0}},\"name\":[\"a\",\"b\"],\"position\":[0.5," + position + "]}}");
        Assert.That((await client.ReceiveAsync()).Text, Does.Contain("dropped"));

        await Soon.BecomesAsync(
            () => StateAsync().Result.GetProperty("joints").EnumerateArray().All(joint => joint.GetProperty("state").GetString() == "refused"), "both are refused");
        var lines = await ReadyAsync(HttpStatusCode.ServiceUnavailable);
        Assert.That(lines, Has.Length.EqualTo(3));
        Assert.That(lines[1], Does.StartWith($"joint a (rosbridge) is refused: the gateway drops the samples of rosbridge 127.0.0.1: {reason} (since "));
    }

    // The stamp of the second case is 30 s ahead of the control clock.
    [TestCase("NaN", 5000, "position of joint c is NaN (NotFinite)")]
    [TestCase("1.5", 5030, "the time stamp is later than the control time (StampInFuture)")]
    public async Task Joints_SourceWithoutValidSamples_AreRefusedWhileAnotherIsLive(string position, int seconds, string reason)
    {
        await StartAsync();
        Publish("a");
        using var client = await RawRosbridgeClient.ConnectAsync(_gateway);

        await client.SendAsync(Invalid("c", seconds, position));
        Assert.That((await client.ReceiveAsync()).Text, Does.Contain("dropped"));

        var lines = await ReadyAsync(HttpStatusCode.ServiceUnavailable);
        Assert.That(lines, Has.Length.EqualTo(2));
        Assert.That(lines[1], Does.StartWith($"joint c (rosbridge) is refused: the gateway drops the samples of rosbridge 127.0.0.1: {reason} (since "));
        var joints = (await StateAsync()).GetProperty("joints").EnumerateArray();
        Assert.That(joints.Select(joint => joint.GetProperty("state").GetString()), Is.EqualTo(new[] { "live", "refused" }));
        await BeginsAsync("joint", "c (rosbridge)");
    }

    [TestCase("NaN", 5000)]
    [TestCase("1.5", 5030)]
    public async Task Joint_InInvalidSamplesOfAnotherSource_StaysLive(string position, int seconds)
    {
        await StartAsync();
        Publish("a");
        using var client = await RawRosbridgeClient.ConnectAsync(_gateway);

        await client.SendAsync(Invalid("a", seconds, position));
        Assert.That((await client.ReceiveAsync()).Text, Does.Contain("dropped"));

        Assert.That(await ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));
        // The gateway counts the refusal after it has answered the client.
        const string Expected = "source rosbridge 127.0.0.1 is refused for joint a: the source gateway already publishes this joint";
        string Text() => StateAsync().Result.GetProperty("status").GetProperty("text").GetString();
        await Soon.BecomesAsync(() => Text().StartsWith(Expected, StringComparison.Ordinal), () => Text());
    }

    static string Invalid(string joint, int seconds, string position) =>
        "{\"op\":\"publish\",\"topic\":\"/joint_states\",\"msg\":{\"header\":{\"stamp\":{\"sec\":" + seconds
        + ",\"nanosec\":0}},\"name\":[\"" + joint + "\"],\"position\":[" + position + "]}}";

    // RFC 6455, 7.4.1: normal closure, client going away, close without a code, and a client error. Null closes without a close frame.
    [TestCase("03E8", "ok")]
    [TestCase("03E9", "ok")]
    [TestCase("", "ok")]
    [TestCase("03F3", "warning")]
    [TestCase(null, "warning")]
    public async Task Headset_ConnectionEnds_IsLostUnlessItClosedInOrder(string close, string level)
    {
        await StartAsync();
        using var client = await RawWebSocket.OpenAsync(_gateway);
        await client.SendTextAsync(RosbridgeWriter.PublishDiagnostics(
            RosTopics.Diagnostics, new DiagnosticsMessage(Gateways.Start, "goggles", [KeyValuePair.Create("pose", "current")]), RosTimeForm.Sec));
        await Soon.BecomesAsync(() => StateAsync().Result.GetProperty("headsets").GetArrayLength() == 1, "it is known");

        if (close != null) await client.SendFrameAsync(RawWebSocket.Close, Convert.FromHexString(close));
        client.EndSending();
        await Soon.BecomesAsync(() => _gateway.WebSocketConnections.Open == 0, "the connection is over");
        _time.Advance(TimeSpan.FromSeconds(4));

        var state = await StateAsync();
        Assert.That(state.GetProperty("status").GetProperty("level").GetString(), Is.EqualTo(level), state.GetRawText());
        Assert.That(state.GetProperty("headsets").GetArrayLength(), Is.EqualTo(level == "ok" ? 0 : 1));
        if (level != "ok") Assert.That(state.GetProperty("status").GetProperty("text").GetString(), Does.Contain("its reports stopped without a normal end"));
    }

    [Test]
    public async Task Source_SecondWithoutAName_IsRefusedWithItsAddress()
    {
        await StartAsync();
        using var first = await RawRosbridgeClient.ConnectAsync(_gateway);
        using var second = await RawRosbridgeClient.ConnectAsync(_gateway);
        await first.SendAsync(Gateways.StateText(1));
        await first.RoundTripAsync();
        await second.SendAsync(Gateways.StateText(1));
        await second.ExpectErrorAsync("another source");

        Assert.That(
            (await StateAsync()).GetProperty("status").GetProperty("text").GetString(),
            Does.Match("^source rosbridge 127[.]0[.]0[.]1 is refused for joint a: "
                + "the source rosbridge 127[.]0[.]0[.]1 already publishes this joint [(]since .*[)][.] Stop one of the two sources[.]$"));
    }

    [Test]
    public async Task Source_RefusedWithoutANameAndReconnects_IsOneEvent()
    {
        await StartAsync();
        Publish("a");
        for (var i = 0; i < 12; i++)
        {
            using var client = await RawRosbridgeClient.ConnectAsync(_gateway);
            await client.SendAsync(Gateways.StateText(1));
            await client.ExpectErrorAsync("another source");
        }

        await BeginsAsync("source", "rosbridge 127.0.0.1 of joint a");
        Assert.That((await StateAsync()).GetProperty("events").GetArrayLength(), Is.EqualTo(1));
    }

    [Test]
    public async Task Ready_NoSourceYet_ContainsStartTimeAndRemedy()
    {
        await StartAsync(options => options with { ExpectsSources = true });
        // The first complete check publishes the state of the joints.
        var looked = new TaskCompletionSource();
        using var listening = _gateway.Hub.Subscribe(RosTopics.JointStatus, _ => looked.TrySetResult());
        await looked.Task.Bounded();
        _time.Advance(TimeSpan.FromSeconds(75));
        await BeginsAsync("source", "of joint positions");

        Assert.That((await ReadyAsync(HttpStatusCode.ServiceUnavailable))[1], Is.EqualTo(
            "a source of joint positions is missing: no adapter has reported a joint and no sample has arrived (since 2026-11-20 12:00:00 UTC). "
                + "Check that the adapter of each plant runs and is connected."));
    }

    [Test]
    public async Task Joint_OutsideItsLimits_IsNamedWithPositionLimitsAndUnit()
    {
        await StartAsync();
        using var description = _gateway.Hub.OpenSource();
        description.TryDescribe(RobotFiles.LoadText("youbot"));

        await Soon.BecomesAsync(
            () =>
            {
                _source.TryPublish(Gateways.State(200, "arm_joint_3"));
                return EventAsync("limit", "arm_joint_3").Result.ValueKind == JsonValueKind.Object;
            },
            "the joint is outside its limits");

        var one = await EventAsync("limit", "arm_joint_3");
        Assert.That(one.GetProperty("what").GetString(), Is.EqualTo("is exceeded"));
        Assert.That(one.GetProperty("text").GetString(), Does.Match(
            "^joint arm_joint_3 is outside the limits of the robot description: its position was 200 rad; allowed are [-0-9.]+ to [-0-9.]+ rad[.] "
                + "Check that the description belongs to this robot and that the source sends rad, not degrees[.]$"));
    }

    [Test]
    public async Task Watch_SubscriberThrows_IsLoggedAndTheWatchContinues()
    {
        await StartAsync();
        using var broken = _gateway.Hub.Subscribe(RosTopics.JointStatus, message =>
        {
            if (((DiagnosticsMessage)message.Content).Values.Count > 0) throw new InvalidOperationException("no status today");
        });

        _time.Advance(EventList.StartGrace);
        Report("adapter/press", ("state", "refused"), ("joint/a", $"missing {Since()} "));

        await Soon.BecomesAsync(() => Logged("status: the state could not be updated (InvalidOperationException: no status today)"), "it is in the log");
        Report("adapter/second", ("state", "refused"));
        await BeginsAsync("adapter", "second");
    }

    [Test]
    public async Task State_OfAGateway_NamesItsHost()
    {
        await StartAsync();

        Assert.That((await StateAsync()).GetProperty("host").GetString(), Is.EqualTo(Environment.MachineName));
    }

    [Test]
    public async Task Ready_JointOfTheRobotWithoutASource_IsReportedEverywhere()
    {
        await StartAsync();
        _source.TryDescribe(RobotFiles.LoadText("youbot"));
        string[] all = [.. UnpublishedJoints.NamesOf(RobotFiles.Load("youbot"))];
        Publish(all[1..]);
        await Soon.BecomesAsync(() => IsDescribed(all), "the description is read");
        _time.Advance(UnpublishedJoints.Patience);
        Publish(all[1..]);

        var reasons = await ReadyAsync(HttpStatusCode.ServiceUnavailable);

        Assert.That(reasons[1..], Has.Length.EqualTo(1).And.Some.Contains($"joint {all[0]} (no source) is missing"));
        Assert.That((await StateAsync()).GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("error"));
        Assert.That((await GetAsync("/metrics")).Text, Does.Contain($"joint=\"{all[0]}\",source=\"no source\",state=\"missing\"}} 1"));
        Publish(all);
        await ReadyAsync(HttpStatusCode.OK);
    }

    // Advances the time so that the joint without a source is seen as soon as the robot is known.
    bool IsDescribed(string[] all)
    {
        _time.Advance(TimeSpan.FromMilliseconds(100));
        Publish(all[1..]);
        return JsonDocument.Parse(GetAsync("/operations/state").Result.Text).RootElement.GetProperty("joints").GetArrayLength() == all.Length;
    }
}
