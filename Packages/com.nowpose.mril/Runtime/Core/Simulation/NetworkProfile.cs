using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Messages;

namespace Nowpose.Simulation
{
    /// <summary>One-way delay of a simulated network: a fixed part, gamma-distributed jitter and rare bursts of long delays.</summary>
    public sealed class NetworkProfile
    {
        /// <summary>Wired network of a cell.</summary>
        public static readonly NetworkProfile Lan = new NetworkProfile("lan", 0.15, 1.5, 0.04, 0.002, 0.002, 0.5, 3);

        /// <summary>Good WiFi.</summary>
        public static readonly NetworkProfile Wifi = new NetworkProfile("wifi", 1.5, 1.2, 0.6, 0.01, 0.03, 5, 30);

        /// <summary>Poor WiFi on a busy channel.</summary>
        public static readonly NetworkProfile BusyWifi = new NetworkProfile("busy-wifi", 1.5, 1, 3, 0.03, 0.1, 20, 100);

        public static readonly IReadOnlyList<NetworkProfile> All = new[] { Lan, Wifi, BusyWifi };

        NetworkProfile(
            string name, double baseMs, double gammaShape, double gammaScaleMs,
            double spikeChanceUp, double spikeChanceDown, double minSpikeMs, double maxSpikeMs)
        {
            Name = name;
            BaseMs = baseMs;
            GammaShape = gammaShape;
            GammaScaleMs = gammaScaleMs;
            SpikeChanceUp = spikeChanceUp;
            SpikeChanceDown = spikeChanceDown;
            MinSpikeMs = minSpikeMs;
            MaxSpikeMs = maxSpikeMs;
        }

        public string Name { get; }

        /// <summary>Fixed delay of every packet, ms.</summary>
        public double BaseMs { get; }

        public double GammaShape { get; }

        /// <summary>Scale of the gamma distribution, ms.</summary>
        public double GammaScaleMs { get; }

        /// <summary>Probability that a packet from the headset begins a burst.</summary>
        public double SpikeChanceUp { get; }

        /// <summary>Probability that a packet to the headset begins a burst.</summary>
        public double SpikeChanceDown { get; }

        /// <summary>Minimum additional delay in a burst, ms.</summary>
        public double MinSpikeMs { get; }

        /// <summary>Maximum additional delay in a burst, ms.</summary>
        public double MaxSpikeMs { get; }

        /// <inheritdoc cref="MinSpikeMs"/>
        [Obsolete("use MinSpikeMs")]
        public double LeastSpikeMs => MinSpikeMs;

        /// <inheritdoc cref="MaxSpikeMs"/>
        [Obsolete("use MaxSpikeMs")]
        public double GreatestSpikeMs => MaxSpikeMs;

        /// <exception cref="InputException">No profile has that name.</exception>
        public static NetworkProfile Named(string name) =>
            All.FirstOrDefault(profile => profile.Name == name)
            ?? throw new InputException(SettingMessages.UnknownNetwork(name, string.Join(", ", All.Select(p => p.Name))));

        /// <summary>Creates the delays from the headset to the control system.</summary>
        internal PathDelay Up(int seed) => new PathDelay(this, SpikeChanceUp, seed);

        /// <summary>Creates the delays from the control system to the headset.</summary>
        internal PathDelay Down(int seed) => new PathDelay(this, SpikeChanceDown, seed);
    }
}
