using NUnit.Framework;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>A gateway that has the plant, a real broker, and a gateway of another hall, joined by the two bridges as processes.</summary>
public class BrokerBridgeTests
{
    const string Topic = "nowpose/cell-1";

    /// <summary>Far from the time of this machine: nothing can agree with it by chance.</summary>
    static readonly ControlTime PlantStart = ControlTime.FromSeconds(70_000);

    [Test]
    public async Task OtherHall_Headset_GetsThePlantsSamplesAndTime()
    {
        if (!File.Exists(Path.Combine(AppContext.BaseDirectory, "adapters", "plant.mjs"))) Assert.Ignore("Node.js was missing when this was built");
        using var folder = new TemporaryFolder();
        using var broker = await Mosquitto.StartAsync(folder.Path);
        var plantTime = new StopwatchControlClock(PlantStart, 60e-6);
        await using var near = await Gateways.StartAsync(clock: plantTime);
        await using var far = await Gateways.StartAsync();
        var publish = Configure(folder, "publish", broker, "");
        var subscribe = Configure(folder, "subscribe", broker, $"  clock: {{ host: 127.0.0.1, port: {near.SyncEndPoint.Port} }}\n");
        await using var nearBridge = AdapterProcesses.Start([new PlantFile(publish, "hall", "")], near);
        await using var farBridge = AdapterProcesses.Start([new PlantFile(subscribe, "hall", "")], far);
        // When it counts as settled, scatter decides, and with it what else the machine does; how far it may be off, it says from the first.
        await Soon.BecomesAsync(
            () => far.PlantClocks.Control is { Name: "hall", Exchanges: >= 10 } hall && hall.Model.ErrorBound < TimeSpan.FromMilliseconds(50),
            "the other hall has the plant's time");
        using var source = near.Hub.OpenSource();
        using var headset = await RawRosbridgeClient.ConnectAsync(far);
        await headset.SubscribeAsync(RosTopics.JointStates);

        var state = await FirstAsync(headset, () => source.TryPublish(new JointStateMessage(plantTime.Now, ["a"], [0.25])));
        using var sync = await RawSyncClient.ConnectAsync(far);
        var before = plantTime.Now;
        var reply = (await sync.ExchangeAsync(SyncFrame.Request(1, 42))).Value;
        var after = plantTime.Now;

        var bound = TimeSpan.FromMicroseconds(reply.ErrorBoundUs);
        TestContext.Out.WriteLine($"bound of the other hall's clock {bound.TotalMilliseconds:0.000} ms");
        Assert.That(state.Names, Is.EqualTo(new[] { "a" }));
        Assert.That(state.Positions, Is.EqualTo(new[] { 0.25 }));
        Assert.That(state.Stamp, Is.InRange(PlantStart, after), "the plant's own stamp");
        Assert.That(bound, Is.GreaterThan(TimeSpan.Zero).And.LessThan(TimeSpan.FromSeconds(1)));
        Assert.That(ControlTime.FromNanoseconds(reply.T2Ns), Is.InRange(before - bound, after + bound));
    }

    /// <summary>The first joint state that gets through; one is published until then.</summary>
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
