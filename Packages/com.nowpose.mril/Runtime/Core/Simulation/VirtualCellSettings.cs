using System;

namespace Nowpose.Simulation
{
    /// <summary>
    /// Sampling and network conditions of a <see cref="VirtualCell"/>. Immutable; checked in the constructor, which allocates nothing.
    /// </summary>
    public readonly struct VirtualCellSettings
    {
        /// <param name="samplingMs">T_s, sampling interval, ms, 5 to 1000.</param>
        /// <param name="latencyMinMs">Minimum time from t_k until a sample is sent, ms, 0 to 2000: subscription and middleware.</param>
        /// <param name="latencyMaxMs">Maximum of this time, ms. The time is uniformly distributed, and samples keep their order.</param>
        /// <param name="jitterMs">
        /// Maximum additional delay of each packet of samples and sync exchanges, ms, 0 to 1000, uniformly distributed; samples
        /// may overtake each other.
        /// </param>
        /// <param name="loss">Probability that a packet is lost, 0 to 1.</param>
        /// <param name="network">Additional delays of the network between the cell and the headset.</param>
        /// <exception cref="InputException">A value is out of range.</exception>
        public VirtualCellSettings(
            double samplingMs, double latencyMinMs, double latencyMaxMs, double jitterMs, double loss, NetworkProfile network)
        {
            SamplingInterval = SettingRange.RequireMs(samplingMs, 5, 1000, "sampling interval");
            LatencyMin = SettingRange.RequireMs(latencyMinMs, 0, 2000, "minimum latency");
            LatencyMax = SettingRange.RequireMs(latencyMaxMs, latencyMinMs, 2000, "maximum latency");
            Jitter = SettingRange.RequireMs(jitterMs, 0, 1000, "jitter");
            Loss = SettingRange.Require(loss, 0, 1, "loss", "");
            Network = network ?? throw new ArgumentNullException(nameof(network));
        }

        public TimeSpan SamplingInterval { get; }
        public TimeSpan LatencyMin { get; }
        public TimeSpan LatencyMax { get; }
        public TimeSpan Jitter { get; }
        public double Loss { get; }
        public NetworkProfile Network { get; }
    }
}
