using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Faults;

/// <summary>Tests failures of the network that do not close the connections.</summary>
[Parallelizable(ParallelScope.All)]
public class PathFaultTests
{
    [Test]
    public async Task Wifi_LostUntilTheGatewayGivesUp_HeadsetShowsTheFaultAndRecovers()
    {
        var clock = new StopwatchControlClock(Gateways.Start);
        await using var gateway = await Gateways.StartAsync(clock: clock);
        using var cell = FaultCell.In(gateway.Hub, clock);
        using var sync = new QuietPath(gateway.SyncEndPoint);
        using var positions = new QuietPath(gateway.WebSocketEndPoint);
        using var headset = new FaultHeadset(sync.Port, positions.Port);
        await headset.BecomesAsync(PoseState.Current);

        sync.GoQuiet();
        positions.GoQuiet();
        await headset.BecomesAsync(() => headset.State != PoseState.Current, "no longer shown as current");
        await headset.BecomesAsync(
            () => headset.State != PoseState.Current && gateway.WebSocketConnections.Open == 0, "the gateway has given up the WebSocket");
        sync.Recover();
        positions.Recover();
        var took = await headset.BecomesAsync(PoseState.Current);

        Recovery.Print("WiFi gone until the gateway has given up the WebSocket", took);
        await headset.BecomesAsync(() => headset.IsClockCorrect(clock), "the estimate of the clock is correct");
    }

    [Test]
    public async Task HalfOpenSource_AfterTheTimeout_ReleasesItsJoints()
    {
        await using var gateway = await Gateways.StartAsync();
        using var path = new QuietPath(gateway.WebSocketEndPoint);
        using var first = await RawRosbridgeClient.ConnectAsync(new Uri($"ws://127.0.0.1:{path.Port}/"));
        await first.SendAsync(Gateways.StateText(1));
        await first.RoundTripAsync();
        using var second = await RawRosbridgeClient.ConnectAsync(gateway);
        await second.SendAsync(Gateways.StateText(2));
        await second.ExpectErrorAsync("another source");

        // From now on, the first client cannot be reached, but its connection is not closed (no FIN).
        path.GoQuiet();

        // The second client answers pings only while it receives, so it must receive during the wait.
        var took = await Soon.BecomesAsync(
            () =>
            {
                second.RoundTripAsync().GetAwaiter().GetResult();
                return gateway.WebSocketConnections[Closure.Silence] == 1;
            },
            "the first client is closed for silence");
        await second.SendAsync(Gateways.StateText(3));
        await second.RoundTripAsync();
        Assert.That(gateway.Drops[DropReason.JointTaken], Is.EqualTo(1), "the joint belongs to the second source now");
        Recovery.Print("half-open WebSocket of a source noticed", took);
    }

    [Test]
    public async Task HalfOpenConnections_AfterTheTimeout_AreClosed()
    {
        var options = Gateways.Options() with { SyncSilence = TimeSpan.FromSeconds(2), MaxConnections = 20 };
        await using var gateway = await Gateways.StartAsync(options);
        using var sync = new QuietPath(gateway.SyncEndPoint);
        using var positions = new QuietPath(gateway.WebSocketEndPoint);
        var clients = new List<IDisposable>();
        try
        {
            for (var i = 0; i < options.MaxConnections; i++)
            {
                var client = await RawSyncClient.ConnectAsync(sync.EndPoint);
                clients.Add(client);
                Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);
                var socket = await RawRosbridgeClient.ConnectAsync(new Uri($"ws://127.0.0.1:{positions.Port}/"));
                clients.Add(socket);
                await socket.SubscribeAsync(RosTopics.JointStates);
            }

            sync.GoQuiet();
            positions.GoQuiet();

            await Soon.BecomesAsync(() => gateway.SyncConnections.Open == 0 && gateway.WebSocketConnections.Open == 0, "all are closed");
            Assert.That(gateway.SyncConnections[Closure.Silence], Is.EqualTo(options.MaxConnections));
            Assert.That(gateway.WebSocketConnections[Closure.Silence], Is.EqualTo(options.MaxConnections));
            using var next = await RawSyncClient.ConnectAsync(gateway);
            Assert.That(await next.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);
        }
        finally
        {
            foreach (var client in clients) client.Dispose();
        }
    }
}
