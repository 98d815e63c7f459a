using System.Runtime.CompilerServices;
using System.Text;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests that the gateway keeps no data of a client that has disconnected.</summary>
[NonParallelizable]
public class DisconnectedClientTests
{
    const int Clients = 100;

    [Test]
    public void Session_Disposed_IsNoLongerReferenced()
    {
        var hub = new MessageHub();
        var plant = new PlantClocks(null, new StopwatchHeadsetClock());
        var clock = new ServedClock(new StopwatchControlClock(Gateways.Start), plant);
        var names = new NamesInUse(TimeProvider.System);

        var departed = Enumerable.Range(0, Clients).Select(i => Depart(hub, clock, plant, names, i)).ToArray();
        Collect();

        Assert.That(departed.Count(session => session.IsAlive), Is.Zero);
        Assert.That(hub.Topics, Is.Zero);
        GC.KeepAlive(names);
        GC.KeepAlive(clock);
    }

    [Test]
    public async Task Clients_DisconnectedFromBothPorts_LeaveNoConnectionsOrTopics()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });
        var topics = gateway.Hub.Topics;

        for (var i = 0; i < Clients; i++)
        {
            using var socket = await RawRosbridgeClient.ConnectAsync(
                gateway, set => set.SetRequestHeader("Authorization", "Bearer " + Gateways.SourceToken));
            await socket.SendAsync(RosbridgeWriter.Subscribe($"/topic_{i}"));
            await socket.ReceiveAsync(); // the warning that the gateway has no such topic
            await socket.SendAsync(Gateways.StateText(i, $"joint_{i}"));
            await socket.RoundTripAsync();
            using var sync = await RawSyncClient.ConnectAsync(gateway);
            await sync.SendAsync(SyncToken.Write(Gateways.ObserverToken));
            await sync.ReceiveAsync();
        }

        await Soon.BecomesAsync(() => gateway.SyncConnections.Open == 0 && gateway.WebSocketConnections.Open == 0, "all connections are closed");
        Assert.That(gateway.Hub.Topics, Is.EqualTo(topics));
        Assert.That(gateway.WatchedTokens, Is.Zero);
        await Soon.BecomesAsync(() => gateway.PendingCount == 0, "no connection is counted");
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    static WeakReference Depart(MessageHub hub, ServedClock clock, PlantClocks plant, NamesInUse names, int number)
    {
        var drops = new DropCounters();
        var started = new List<Subscription>();
        var session = new RosbridgeSession(hub, clock, plant, names, Role.Source, drops, 16, _ => { }, started.Add);
        foreach (var text in new[]
            {
                RosbridgeWriter.Subscribe(RosTopics.JointStates), RosbridgeWriter.Subscribe($"/topic_{number}"),
                RosbridgeWriter.Advertise(RosTopics.JointStates, RosTopics.JointStateType), Gateways.StateText(number, $"joint_{number}"),
                RosbridgeWriter.Publish(
                    RosTopics.Diagnostics, new DiagnosticsMessage(Gateways.Start, $"headset {number}", []), RosTimeForm.Sec),
                """{"op":"advertise_service","service":"/nowpose/plant_time/plc","type":"nowpose/PlantTime"}""",
            })
            session.Handle(new Received(Encoding.UTF8.GetBytes(text), DropReason.None, null));
        Assert.That(started, Has.Count.EqualTo(2));
        Assert.That(drops.Total, Is.Zero);
        session.Dispose();
        return new WeakReference(session);
    }

    static void Collect()
    {
        for (var i = 0; i < 3; i++)
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
        }
    }
}
