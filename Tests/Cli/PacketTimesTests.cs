using System.Diagnostics;
using Nowpose.Cli.Demo;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli;

/// <summary>Tests the delivery times of the demo's simulated network.</summary>
public sealed class PacketTimesTests
{
    const int Seed = 78, Packets = 1200;

    static readonly long Millisecond = Stopwatch.Frequency / 1000;

    static readonly NetworkProfile Network = NetworkProfile.BusyWifi;

    /// <summary>Gets the delays of data that are sent every 50 ms, each followed by more data after the given times, ms.</summary>
    static double[] Delays(params double[] followers)
    {
        var times = new PacketTimes(Network.Down(Seed));
        return [.. Enumerable.Range(0, Packets).Select(packet =>
        {
            var sent = 50 * Millisecond * packet;
            var delay = (times.DueAt(sent) - sent) / (double)Millisecond;
            foreach (var after in followers) times.DueAt(sent + (long)(after * Millisecond));
            return delay;
        })];
    }

    // The order of the data can delay the next packet by at most the time between the data of the previous one.
    [Test]
    public void DueAt_MoreDataInTheSameCycle_HasTheDelayOfThePacket() => Assert.That(
        Delays(0.1, 0.4).Zip(Delays(), (more, alone) => more - alone), Is.All.InRange(-0.001, 0.401), $"seed {Seed}");

    [Test]
    public void DueAt_MoreDataLater_TravelInAPacketOfTheirOwn() => Assert.That(Delays(2), Is.Not.EqualTo(Delays()), $"seed {Seed}");

    [Test]
    public void DueAt_OnePacketAtATime_HasTheDelaysOfTheNetworkInOrder()
    {
        var network = Network.Down(Seed);
        var due = 0.0;

        var expected = Enumerable.Range(0, Packets).Select(packet =>
        {
            due = Math.Max(due, 50 * packet + network.Next().TotalMilliseconds);
            return due - 50 * packet;
        });

        Assert.That(Delays(), Is.EqualTo(expected).Within(0.001), $"seed {Seed}");
    }
}
