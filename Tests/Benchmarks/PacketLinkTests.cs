using NUnit.Framework;
using Nowpose.Benchmarks.Links;

namespace Nowpose.Headless.Tests.Benchmarks;

/// <summary>Compares loss and delay of individual packets with the distributions of the profiles.</summary>
public class PacketLinkTests
{
    static readonly HeadsetTime Start = HeadsetTime.FromSeconds(1000);

    [TestCase("clean", 1, 0.2)]
    [TestCase("wifi", 2, 4)]
    [TestCase("lossy", 3, 6)]
    [TestCase("cellular", 14, 3)]
    [TestCase("bad", 5, 12)]
    [TestCase("roaming", 3, 5)]
    public void Delays_PacketsFarApart_AreTheBaseDelayPlusExponentialJitter(string name, double baseMs, double jitterMs)
    {
        // 40 packets take 7.6 s. The first stall of the roaming link is at 8 s.
        var ms = new List<double>();
        for (var seed = 0; seed < 200; seed++)
            ms.AddRange(Packets(Link(name, seed), 40, 0.19).Where(p => p.Arrived).Select(p => p.DelayMs));

        Assert.That(ms.Min(), Is.InRange(baseMs, baseMs + 0.02 * jitterMs));
        Assert.That(ms.Average() - baseMs, Is.EqualTo(jitterMs).Within(5).Percent);
        // In an exponential distribution, the share of values above three means is e^-3.
        Assert.That(ms.Average(d => d > baseMs + 3 * jitterMs ? 1.0 : 0), Is.EqualTo(Math.Exp(-3)).Within(0.01));
    }

    [TestCase("clean", 0)]
    [TestCase("wifi", 0.002)]
    [TestCase("lossy", 0.02)]
    [TestCase("cellular", 0)]
    [TestCase("bad", 0.05)]
    public void Loss_ManyPackets_EqualsTheLossOfTheProfile(string name, double loss)
    {
        var lost = Packets(Link(name, 3), 100_000, 0.01).Average(p => p.Arrived ? 0.0 : 1);

        Assert.That(lost, Is.EqualTo(loss).Within(0.003 * Math.Sign(loss)));
    }

    [Test]
    public void Order_PacketsCloseTogether_IsKept()
    {
        var packets = Packets(Link("bad", 5), 10_000, 0.001).Where(p => p.Arrived).ToList();

        Assert.That(packets.Zip(packets.Skip(1), (a, b) => a.Arrival <= b.Arrival), Is.Not.Empty.And.All.True);
        Assert.That(packets.Min(p => p.DelayMs), Is.GreaterThanOrEqualTo(5));
    }

    [Test]
    public void Order_NotKept_PacketsOvertakeOthers()
    {
        var link = new PacketLink(LinkProfile.Bad, Start, 5, keepsOrder: false);

        var packets = Packets(link, 10_000, 0.001).Where(p => p.Arrived).ToList();

        // A packet overtakes its predecessor if the predecessor is delayed by at least 1 ms more. The probability is e^(-1/12) / 2.
        Assert.That(packets.Zip(packets.Skip(1), (a, b) => a.Arrival > b.Arrival ? 1.0 : 0).Average(), Is.EqualTo(0.46).Within(0.02));
    }

    [Test]
    public void Stall_PacketsSentDuringTheStall_ArriveAtItsEndInOrder()
    {
        var packets = Packets(Link("roaming", 7), 3000, 0.01);

        // Three stalls in 30 s, at 8, 16 and 24 s, each of 1.5 s.
        Assert.That(packets.All(p => p.Arrived));
        var arrivals = packets.Select(p => (p.Arrival - Start).TotalSeconds);
        Assert.That(arrivals.Where(s => s >= 8).Select(s => s % 8), Is.Not.Empty.And.All.GreaterThanOrEqualTo(1.5));
        foreach (var begin in new[] { 8.0, 16, 24 })
        {
            var stalled = packets.Where(p => (p.Sent - Start).TotalSeconds is var s && s >= begin && s < begin + 1.45).ToList();
            Assert.That(stalled, Has.Count.EqualTo(145));
            Assert.That(stalled.All(p => p.Arrival == Start + ClockTicks.Span(begin + 1.5)));
        }
        Assert.That(packets.Zip(packets.Skip(1), (a, b) => a.Arrival <= b.Arrival), Is.Not.Empty.And.All.True);
    }

    [Test]
    public void Stalls_OfBothDirections_AreSimultaneous()
    {
        var during = Start + TimeSpan.FromSeconds(9);

        Link("roaming", 1).TrySend(during, out var up);
        Link("roaming", 2).TrySend(during, out var down);

        Assert.That(up, Is.EqualTo(down));
    }

    [Test]
    public void TrySend_SameSeed_Repeats()
    {
        Assert.That(Packets(Link("bad", 5), 100, 0.1), Is.EqualTo(Packets(Link("bad", 5), 100, 0.1)));
        Assert.That(Packets(Link("bad", 5), 100, 0.1), Is.Not.EqualTo(Packets(Link("bad", 6), 100, 0.1)));
    }

    [Test]
    public void Named_UnknownName_ThrowsWithAllNames()
    {
        var error = Assert.Throws<InputException>(() => LinkProfile.Named("5g"));

        Assert.That(error.Message, Does.EndWith("clean, wifi, lossy, cellular, bad, roaming"));
    }

    static PacketLink Link(string name, int seed) => new PacketLink(LinkProfile.Named(name), Start, seed);

    static List<Packet> Packets(PacketLink link, int count, double intervalSeconds)
    {
        var packets = new List<Packet>(count);
        for (var i = 0; i < count; i++)
        {
            var sent = Start + ClockTicks.Span(i * intervalSeconds);
            var arrived = link.TrySend(sent, out var arrival);
            packets.Add(new Packet(sent, arrived, arrival));
        }
        return packets;
    }

    readonly struct Packet
    {
        public Packet(HeadsetTime sent, bool arrived, HeadsetTime arrival)
        {
            Sent = sent;
            Arrived = arrived;
            Arrival = arrival;
        }

        public readonly HeadsetTime Sent;
        public readonly bool Arrived;
        public readonly HeadsetTime Arrival;

        public double DelayMs => (Arrival - Sent).TotalMilliseconds;
    }
}
