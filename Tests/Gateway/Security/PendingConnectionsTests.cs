using System.Net;
using Nowpose.Gateway;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

[Parallelizable(ParallelScope.All)]
public class PendingConnectionsTests
{
    static readonly IPEndPoint Nat = new(IPAddress.Parse("10.0.0.1"), 1), Other = new(IPAddress.Parse("10.0.0.2"), 1);

    [Test]
    public void Enter_TooManyConnectionsFromOneAddress_EvictsItsOldest()
    {
        var evicted = new List<string>();
        var pending = new PendingConnections(2);
        pending.Enter(Other, () => evicted.Add("other"));

        foreach (var name in new[] { "a", "b", "c", "d" }) pending.Enter(Nat, () => evicted.Add(name));

        Assert.That(evicted, Is.EqualTo(new[] { "a", "b" }));
        Assert.That(pending.Count, Is.EqualTo(3));
    }

    [Test]
    public void Enter_ManySilentConnections_EvictsNoneWithCompletedHandshake()
    {
        var evicted = new List<string>();
        var pending = new PendingConnections(2);
        var headset = pending.Enter(Nat, () => evicted.Add("headset"));
        headset.CompleteHandshake();

        for (var i = 0; i < 100; i++) pending.Enter(Nat, () => evicted.Add("silent"));

        Assert.That(evicted, Has.Count.EqualTo(98).And.All.EqualTo("silent"));
        headset.Dispose();
        headset.Dispose();
        Assert.That(pending.Count, Is.EqualTo(2));
    }

    [Test]
    public void CompleteHandshake_TooManyFromOneAddress_EvictsTheOldestFromThatAddress()
    {
        var evicted = new List<string>();
        var pending = new PendingConnections(2);

        foreach (var name in new[] { "a", "b", "c" }) pending.Enter(Nat, () => evicted.Add(name)).CompleteHandshake();

        Assert.That(evicted, Is.EqualTo(new[] { "a" }));
    }

    [Test]
    public void Enter_TotalLimitReached_EvictsTheOldestSilentConnection()
    {
        var evicted = new List<string>();
        var pending = new PendingConnections(10, maxInAll: 2);
        pending.Enter(Other, () => evicted.Add("known")).CompleteHandshake();
        pending.Enter(Other, () => evicted.Add("silent"));

        pending.Enter(Nat, () => evicted.Add("new"));

        Assert.That(evicted, Is.EqualTo(new[] { "silent" }));
        Assert.That(pending.TryEvictOldest(), Is.True);
        Assert.That(evicted, Is.EqualTo(new[] { "silent", "new" }));
        Assert.That(pending.TryEvictOldest() && pending.TryEvictOldest(), Is.False, "only one connection can be evicted");
    }

    [TestCase(false)]
    [TestCase(true)]
    public async Task Headset_ManyUnfinishedConnections_StillConnects(bool isOtherAddress)
    {
        // The total limit is equal to the limit per address.
        var options = Gateways.Options() with { Tokens = Gateways.Tokens, MaxPendingConnections = 8, MaxConnections = 8, TokenTimeout = TimeSpan.FromMinutes(5) };
        await using var gateway = await Gateways.StartAsync(options);
        var silent = new List<IDisposable>();
        try
        {
            for (var i = 0; i < 20; i++)
            {
                silent.Add(await RawSyncClient.ConnectAsync(gateway.SyncEndPoint, IPAddress.Parse(isOtherAddress ? $"127.0.0.{i + 2}" : "127.0.0.1")));
                silent.Add(await RawWebSocket.ConnectAsync(gateway));
            }

            using var sync = await RawSyncClient.ConnectAsync(gateway);
            await sync.SendAsync(SyncToken.Write(Gateways.ObserverToken));
            Assert.That((await sync.ReceiveAsync()).Value.IsAccepted, Is.True);
            using var socket = await RawRosbridgeClient.ConnectAsync(
                gateway, set => set.SetRequestHeader("Authorization", "Bearer " + Gateways.ObserverToken));
            await socket.RoundTripAsync();

            for (var i = 0; i < 20; i++) silent.Add(await RawSyncClient.ConnectAsync(gateway));
            Assert.That(await sync.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null, "accepted connections are not evicted");
        }
        finally
        {
            foreach (var client in silent) client.Dispose();
        }
    }
}
