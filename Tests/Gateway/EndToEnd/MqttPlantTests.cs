using System.Text.Json;
using NUnit.Framework;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using static Nowpose.Headless.Tests.Gateway.EndToEnd.ShownStatus;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>Runs a broker and the gateway with its MQTT adapter as processes. A client publishes to the broker.</summary>
public class MqttPlantTests
{
    const string Cell = """
        joints:
          - { joint: axis, topic: cell/arm, field: position.1, unit: deg }
        frames:
          - frame: part
            position: { unit: mm, x: { topic: cell/part, field: pose.x }, y: { topic: cell/part, field: pose.y }, z: 50 }
            angles: { order: zyx, axes: moving, unit: deg, values: [{ topic: cell/part, field: pose.a }, 0, 0] }
        signals:
          - { signal: closed, topic: cell/closed }
        """;

    TemporaryFolder _folder;
    Mosquitto _broker;
    PeerProcess _gateway;
    HttpClient _http;

    [SetUp]
    public async Task Start()
    {
        Needs.Adapters();
        _folder = new TemporaryFolder();
        _broker = await Mosquitto.StartAsync(_folder.Path);
        // The broker receives this message before the gateway subscribes.
        using (var client = await MqttPublisher.ConnectAsync(_broker.Port)) await client.PublishAsync("cell/closed", "true", isRetained: true);
        var file = Path.Combine(_folder.Path, "mqtt.yaml");
        await File.WriteAllTextAsync(file, $"plant:\n  kind: mqtt\n  name: twin\n  endpoint: mqtt://127.0.0.1:{_broker.Port}\n{Cell}\n");
        _gateway = new PeerProcess("Nowpose.Gateway.dll", "serve", "--plant", file, "--sync-port", "0", "--ws-port", "0");
        await _gateway.PrintsAsync("state serving");
        _http = new HttpClient { BaseAddress = new Uri(_gateway.ValueOf("websocket").Replace("ws://", "http://")) };
    }

    [TearDown]
    public void Stop()
    {
        _http?.Dispose();
        _gateway?.Dispose();
        _broker?.Dispose();
        _folder?.Dispose();
    }

    [Test]
    public async Task Headset_ClientPublishesToTheBroker_ReceivesJointFrameAndSignal()
    {
        using var joints = await SubscribeAsync(RosTopics.JointStates);
        using var frames = await SubscribeAsync(RosTopics.Tf);
        using var signals = await SubscribeAsync(RosTopics.Signals);
        using var client = await MqttPublisher.ConnectAsync(_broker.Port);

        var retained = (await signals.ReceiveAsync()).Signals;
        var (joint, frame) = (joints.ReceiveAsync(), frames.ReceiveAsync());
        await Soon.BecomesAsync(
            () =>
            {
                PublishAsync(client).GetAwaiter().GetResult();
                return joint.IsCompleted && frame.IsCompleted;
            },
            () => _gateway.All);
        await client.PublishAsync("cell/closed", "false");
        // The adapter sends each value repeatedly, so the old value can arrive several times.
        SignalsMessage changed;
        do
            changed = (await signals.ReceiveAsync()).Signals;
        while (changed[0].Value == 1);

        Assert.That((await joint).JointState.Names, Is.EqualTo(new[] { "axis" }));
        Assert.That((await joint).JointState.Positions[0], Is.EqualTo(Math.PI / 2).Within(1e-9));
        var pose = (await frame).Transforms[0];
        Assert.That((pose.Child, pose.Parent), Is.EqualTo(("part", "world")));
        Assert.That(new[] { pose.X, pose.Y, pose.Z }, Is.EqualTo(new[] { 0.4, 0.2, 0.05 }).Within(1e-9));
        Assert.That((retained[0].Name, retained[0].Value, changed[0].Value), Is.EqualTo(("closed", 1.0, 0.0)));
        Assert.That(changed.Stamp, Is.GreaterThan(retained.Stamp));
    }

    [Test]
    public async Task Broker_KilledAndRestarted_IsReportedUntilItsValuesArriveAgain()
    {
        using (var client = await MqttPublisher.ConnectAsync(_broker.Port))
            await BecomesAsync(client, state => IsLive(state, "joints", "axis") && IsLive(state, "frames", "part") && IsLive(state, "signals", "closed"));

        _broker.Kill();
        await BecomesAsync(null, state => IsAway(state) && HasState(state, "joints", "axis", "fault") && HasState(state, "frames", "part", "fault"));
        using (var ready = await _http.GetAsync("readyz")) Assert.That((int)ready.StatusCode, Is.EqualTo(503));
        await _broker.RestartAsync();

        using var again = await MqttPublisher.ConnectAsync(_broker.Port);
        await again.PublishAsync("cell/closed", "true", isRetained: true);
        await BecomesAsync(again, state => Text(state.GetProperty("status"), "level") == "ok" && IsLive(state, "joints", "axis") && IsLive(state, "frames", "part")
            && IsLive(state, "signals", "closed"));
        using (var ready = await _http.GetAsync("readyz")) Assert.That((int)ready.StatusCode, Is.EqualTo(200));
    }

    async Task<RawRosbridgeClient> SubscribeAsync(string topic)
    {
        var client = await RawRosbridgeClient.ConnectAsync(new Uri(_gateway.ValueOf("websocket")));
        await client.SendAsync(RosbridgeWriter.Subscribe(topic));
        return client;
    }

    static async Task PublishAsync(MqttPublisher client)
    {
        await client.PublishAsync("cell/arm", "{\"position\": [0, 90]}");
        await client.PublishAsync("cell/part", "{\"pose\": {\"x\": 400, \"y\": 200, \"a\": 90}}");
    }

    /// <summary>Waits until the state of the gateway fulfils a condition, while a client publishes.</summary>
    Task BecomesAsync(MqttPublisher client, Func<JsonElement, bool> condition)
    {
        JsonElement state = default;
        return Soon.BecomesAsync(
            () =>
            {
                if (client != null) PublishAsync(client).GetAwaiter().GetResult();
                state = JsonDocument.Parse(_http.GetStringAsync("operations/state").GetAwaiter().GetResult()).RootElement;
                return condition(state);
            },
            () => $"{state}\n{_gateway.All}");
    }

    static bool IsLive(JsonElement state, string kind, string name) => HasState(state, kind, name, "live");

    static bool HasState(JsonElement state, string kind, string name, string expected) =>
        state.GetProperty(kind).EnumerateArray().Any(one => Text(one, "name") == name && Text(one, "state") == expected);

    static bool IsAway(JsonElement state) => Text(state.GetProperty("status"), "level") == "error"
        && state.GetProperty("adapters").EnumerateArray().Any(one => Text(one, "name") == "twin" && Text(one, "state") == "waiting");
}
