using System;
using System.Linq;
using Nowpose.Messages;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation
{
    /// <summary>Compares the statistics of simulated delays with the statistics of their distributions, which were computed by hand.</summary>
    public class NetworkProfileTests
    {
        const int Packets = 200_000;

        static double[] DelaysMs(PathDelay path) => Enumerable.Range(0, Packets).Select(_ => path.Next().TotalMilliseconds).ToArray();

        // Mean delay: base, plus shape times scale, plus the mean spike times the share of packets in spikes. A spike starts with probability p
        // and continues with probability 0.3, so this share is p / (p + 1 − 0.3).
        [TestCase("lan", 0.15 + 1.5 * 0.04, 0.002 / 0.702 * 1.75, 0.002 / 0.702 * 1.75)]
        [TestCase("wifi", 1.5 + 1.2 * 0.6, 0.01 / 0.71 * 17.5, 0.03 / 0.73 * 17.5)]
        [TestCase("busy-wifi", 1.5 + 1 * 3, 0.03 / 0.73 * 60, 0.1 / 0.8 * 60)]
        public void Delays_ManyPackets_HaveTheMeanOfTheProfile(string name, double withoutSpikesMs, double spikesUpMs, double spikesDownMs)
        {
            var network = NetworkProfile.Named(name);

            Assert.That(DelaysMs(network.Up(1)).Average(), Is.EqualTo(withoutSpikesMs + spikesUpMs).Within(3).Percent);
            Assert.That(DelaysMs(network.Down(2)).Average(), Is.EqualTo(withoutSpikesMs + spikesDownMs).Within(3).Percent);
        }

        [TestCase("lan", 0.15)]
        [TestCase("wifi", 1.5)]
        [TestCase("busy-wifi", 1.5)]
        public void Delays_ManyPackets_MinimumIsTheBaseDelay(string name, double baseMs)
        {
            Assert.That(DelaysMs(NetworkProfile.Named(name).Up(3)).Min(), Is.InRange(baseMs, baseMs * 1.05));
        }

        [Test]
        public void Delays_Spikes_OccurInBursts()
        {
            var isSpike = DelaysMs(NetworkProfile.Wifi.Down(4)).Select(ms => ms > 6.5).ToArray();

            var afterASpike = Enumerable.Range(1, Packets - 1).Where(i => isSpike[i - 1]).ToList();

            Assert.That(afterASpike.Average(i => isSpike[i] ? 1.0 : 0), Is.EqualTo(0.3).Within(0.03));
        }

        [Test]
        public void Delays_SameSeed_Repeat()
        {
            Assert.That(DelaysMs(NetworkProfile.Wifi.Up(5)).Take(100), Is.EqualTo(DelaysMs(NetworkProfile.Wifi.Up(5)).Take(100)));
            Assert.That(DelaysMs(NetworkProfile.Wifi.Up(5)).Take(100), Is.Not.EqualTo(DelaysMs(NetworkProfile.Wifi.Up(6)).Take(100)));
        }

        [Test]
        public void Named_UnknownName_ThrowsWithAllNames()
        {
            var error = Assert.Throws<InputException>(() => NetworkProfile.Named("5g"));

            Assert.That(error.Message, Is.EqualTo(SettingMessages.UnknownNetwork("5g", "lan, wifi, busy-wifi")));
        }
    }
}
