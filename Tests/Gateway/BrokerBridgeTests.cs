using System.Text.Json;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>
/// Runs a gateway with the plant, a real broker, and a second gateway, as if in another building. Two bridge processes connect them.
/// </summary>
public class BrokerBridgeTests
{
    const string Topic = "nowpose/cell-1";

    /// <summary>Start of the plant's clock. It is far from this machine's time, so no other clock can agree with it by chance.</summary>
    static readonly ControlTime PlantStart = ControlTime.FromSeconds(70_000);

    [Test]
    public async Task Headset_ConnectedToTheOtherGateway_ReceivesThePlantsSamplesAndTime()
    {
        Needs.Adapters();
        using var folder = new TemporaryFolder();
        using var broker = await Mosquitto.StartAsync(folder.Path);
        var plantTime = new StopwatchControlClock(PlantStart, 60e-6);
        await using var near = await Gateways.StartAsync(clock: plantTime);
        await using var far = await Gateways.StartAsync();
        var publish = Configure(folder, "publish", broker, "");
        var subscribe = Configure(folder, "subscribe", broker, $"  clock: {{ host: 127.0.0.1, port: {near.SyncEndPoint.Port} }}\n");
        await using var nearBridge = AdapterProcesses.Start([new PlantFile(publish, "hall", "")], near);
        await using var farBridge = AdapterProcesses.Start([new PlantFile(subscribe, "hall", "")], far);
        // Waits for a small error bound instead of the state synchronised, because a busy machine reaches that state late.
        await Soon.BecomesAsync(
            () => far.PlantClocks.Control is { Name: "hall", Exchanges: >= 10 } hall && hall.Model.ErrorBound < TimeSpan.FromMilliseconds(50),
            "the other hall has the plant's time");
        using var source = near.Hub.OpenSource();
        using var headset = await RawRosbridgeClient.ConnectAsync(far);
        await headset.SubscribeAsync(RosTopics.JointStates);

        var state = await FirstAsync(headset, () => source.Publish(new JointStateMessage(plantTime.Now, ["a"], [0.25])));
        using var sync = await RawSyncClient.ConnectAsync(far);
        var before = plantTime.Now;
        var reply = (await sync.ExchangeAsync(SyncFrame.Request(1, 42))).Value;
        var after = plantTime.Now;

        var bound = TimeSpan.FromMicroseconds(reply.ErrorBoundUs);
        TestContext.Out.WriteLine($"bound of the other hall's clock {bound.TotalMilliseconds:0.000} ms");
        Assert.That(state.Names, Is.EqualTo(new[] { "a" }));
        Assert.That(state.Positions, Is.EqualTo(new[] { 0.25 }));
        Assert.That(state.Stamp, Is.InRange(PlantStart, after), "the sample has the stamp of the plant's clock");
        Assert.That(bound, Is.GreaterThan(TimeSpan.Zero).And.LessThan(TimeSpan.FromSeconds(1)));
        Assert.That(ControlTime.FromNanoseconds(reply.T2Ns), Is.InRange(before - bound, after + bound));
    }

    [Test]
    public async Task OtherGateway_JointsNotLiveAtThePlant_ReportsTheirReasonsUntilThePlantsGatewayEnds()
    {
        Needs.Adapters();
        using var folder = new TemporaryFolder();
        using var broker = await Mosquitto.StartAsync(folder.Path);
        await using var far = await Gateways.StartAsync();
        await using var clock = await Gateways.StartAsync();
        var publish = Configure(folder, "publish", broker, "");
        var subscribe = Configure(folder, "subscribe", broker, $"  clock: {{ host: 127.0.0.1, port: {clock.SyncEndPoint.Port} }}\n");
        await using var farBridge = AdapterProcesses.Start([new PlantFile(subscribe, "hall", "")], far);
        var since = DateTimeOffset.UtcNow.ToUnixTimeSeconds() - 100;
        JsonElement[] joints = [];

        await using (var near = await Gateways.StartAsync())
        {
            await using var nearBridge = AdapterProcesses.Start([new PlantFile(publish, "hall", "")], near);
            using var adapter = near.Hub.OpenSource();
            using var reports = new Timer(
                _ =>
                {
                    adapter.Publish(new JointStateMessage(clock.Clock.Now, ["still"], [0.5]));
                    var now = new ControlTime(DateTime.UtcNow - DateTime.UnixEpoch);
                    adapter.Publish(RosTopics.Diagnostics, new DiagnosticsMessage(now, "plant/press", [
                        new("state", "connected"), new("joint/gone", $"missing {since}.000 the server has no node Axis1"),
                        new("joint/still", $"rest {since}.000 assumed at rest"), new("uncertain/still", "the stop itself was not observed"),
                    ]));
                }, null, TimeSpan.Zero, TimeSpan.FromMilliseconds(500));
            await Soon.BecomesAsync(
                () => (joints = Joints(far)).Select(joint => joint.GetProperty("state").GetString()).SequenceEqual(["missing", "rest"]),
                "the other hall has the joints");
        }

        Assert.That(joints[0].GetProperty("reason").GetString(), Is.EqualTo("the server has no node Axis1"));
        Assert.That(joints[1].GetProperty("uncertain").GetString(), Is.EqualTo("the stop itself was not observed"));
        foreach (var joint in joints)
            Assert.That(joint.GetProperty("since_utc").GetDateTimeOffset().ToUnixTimeSeconds(), Is.EqualTo(since).Within(30));
        await Soon.BecomesAsync(() => Joints(far)[1].GetProperty("state").GetString() == "fault", "the other hall reports the fault");
    }

    static JsonElement[] Joints(GatewayServer gateway)
    {
        using var http = new HttpClient();
        var state = http.GetStringAsync(new Uri($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}/operations/state")).GetAwaiter().GetResult();
        return [.. JsonDocument.Parse(state).RootElement.GetProperty("joints").EnumerateArray()];
    }

    /// <summary>Publishes joint states until the headset receives one, and returns it.</summary>
    static async Task<JointStateMessage> FirstAsync(RawRosbridgeClient headset, Action publish)
    {
        var received = headset.ReceiveAsync();
        await Soon.BecomesAsync(
            () =>
            {
                publish();
                return received.IsCompleted;
            },
            "a joint state of the plant arrives at the other hall");
        return (await received).JointState;
    }

    static string Configure(TemporaryFolder folder, string direction, Mosquitto broker, string more)
    {
        var file = Path.Combine(folder.Path, direction + ".yaml");
        var endpoint = $"mqtt://127.0.0.1:{broker.Port}";
        File.WriteAllText(
            file, $"plant:\n  kind: broker\n  name: hall\n  direction: {direction}\n  endpoint: {endpoint}\n  topic: {Topic}\n{more}");
        return file;
    }
}
