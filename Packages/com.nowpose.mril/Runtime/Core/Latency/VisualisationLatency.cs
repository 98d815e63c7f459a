using System;

namespace Nowpose.Latency
{
    /// <summary>L_visu: render job triggered to light, the part of L = L_app + L_visu (Eq. (1)) that no program can see.</summary>
    /// <remarks>Calibrated, and valid while the render time stays in the constant-latency range. <c>default</c> is zero.</remarks>
    public readonly struct VisualisationLatency
    {
        const double GreatestMs = 500;
        const string Name = "visualisation latency";

        /// <param name="length">0 to 500 ms.</param>
        /// <exception cref="InputException">Out of range.</exception>
        public VisualisationLatency(TimeSpan length)
        {
            SettingRange.Require(length.TotalMilliseconds, 0, GreatestMs, Name, "ms");
            Length = length;
        }

        /// <param name="ms">0 to 500 ms.</param>
        /// <exception cref="InputException">Out of range, or not a number.</exception>
        public static VisualisationLatency FromMilliseconds(double ms) =>
            new VisualisationLatency(SettingRange.RequireMs(ms, 0, GreatestMs, Name));

        public TimeSpan Length { get; }

        /// <summary>When the light of a frame begun now appears, on the headset clock.</summary>
        public HeadsetTime LightOf(HeadsetTime frameStart) => frameStart + Length;

        /// <summary>L of Eq. (1).</summary>
        public TimeSpan EndToEnd(TimeSpan application) => application + Length;
    }
}
