using NUnit.Framework;
using Nowpose.Benchmarks.Links;

namespace Nowpose.Headless.Tests.Benchmarks;

public class PacketQueueTests
{
    static readonly HeadsetTime Start = HeadsetTime.FromSeconds(50);

    [Test]
    public void TryReceive_BeforeTheArrival_ReturnsFalse()
    {
        var queue = Queue("cellular");
        queue.TrySend(Start, 1);
        var arrival = queue.NextArrival.Value;

        Assert.That(arrival - Start, Is.GreaterThanOrEqualTo(TimeSpan.FromMilliseconds(14)));
        Assert.That(queue.TryReceive(arrival - new TimeSpan(1), out _, out _), Is.False);
        Assert.That(queue.TryReceive(arrival, out var packet, out var at), Is.True);
        Assert.That(packet, Is.EqualTo(1));
        Assert.That(at, Is.EqualTo(arrival));
        Assert.That(queue.NextArrival, Is.Null);
    }

    [TestCase("clean")]
    [TestCase("wifi")]
    [TestCase("bad")]
    [TestCase("roaming")]
    public void TryReceive_OrderKept_ReturnsDeliveredPacketsInOrder(string profile)
    {
        var queue = Queue(profile);

        var (sent, received) = Carry(queue, 5000);

        Assert.That(received.Select(r => r.Packet), Is.EqualTo(sent));
        Assert.That(sent, Has.Count.LessThanOrEqualTo(5000).And.Count.GreaterThan(4500));
    }

    [Test]
    public void TryReceive_OrderNotKept_ReturnsPacketsInOrderOfArrival()
    {
        var queue = new PacketQueue<int>(new PacketLink(LinkProfile.Bad, Start, 3, keepsOrder: false));

        var (sent, received) = Carry(queue, 5000);

        Assert.That(received.Select(r => r.Packet), Is.EquivalentTo(sent));
        Assert.That(received.Select(r => r.Packet), Is.Not.EqualTo(sent));
        Assert.That(received.Select(r => r.Arrival.Nanoseconds), Is.Ordered);
    }

    [Test]
    public void TryReceive_DuringAStall_ReturnsNothing()
    {
        var (_, received) = Carry(Queue("roaming"), 5000);

        var arrivals = received.Select(r => (r.Arrival - Start).TotalSeconds).ToList();

        Assert.That(arrivals.Where(s => s >= 8 && s < 9.5), Is.Empty);
        // Packets are sent every 2 ms. At the end of the stall, all packets that were sent within 1.5 s arrive at the same time, together with
        // the packets that were in transit before.
        Assert.That(arrivals.Count(s => s == 9.5), Is.InRange(740, 760));
    }

    static PacketQueue<int> Queue(string profile) => new PacketQueue<int>(new PacketLink(LinkProfile.Named(profile), Start, 3));

    // Sends one packet every 2 ms; the receiver polls every 0.5 ms.
    static (List<int> Sent, List<(int Packet, HeadsetTime Arrival)> Received) Carry(PacketQueue<int> queue, int packets)
    {
        var sent = new List<int>();
        var received = new List<(int Packet, HeadsetTime Arrival)>();
        for (var step = 0; step < 4 * packets + 8000; step++)
        {
            var now = Start + new TimeSpan(step * 5000L);
            if (step % 4 == 0 && step < 4 * packets && queue.TrySend(now, step / 4)) sent.Add(step / 4);
            while (queue.TryReceive(now, out var packet, out var arrival)) received.Add((packet, arrival));
        }
        return (sent, received);
    }
}
