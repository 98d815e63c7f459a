using System;

namespace Nowpose.Latency
{
    /// <summary>L_visu: time from the trigger of the render job to the display time, the part of L of Eq. (1) that software cannot measure.</summary>
    /// <remarks>A calibrated value, valid while the render time is in the constant-latency range. <c>default</c> is zero.</remarks>
    public readonly struct VisualisationLatency
    {
        const string Name = "visualisation latency";

        /// <param name="length">0 to 500 ms.</param>
        /// <exception cref="InputException">The length is out of range.</exception>
        public VisualisationLatency(TimeSpan length)
        {
            SettingRange.Require(length.TotalMilliseconds, 0, LatencyProfile.MaxVisuMs, Name, "ms");
            Length = length;
        }

        /// <param name="ms">0 to 500 ms.</param>
        /// <exception cref="InputException">The value is out of range or not a number.</exception>
        public static VisualisationLatency FromMilliseconds(double ms) =>
            new VisualisationLatency(SettingRange.RequireMs(ms, 0, LatencyProfile.MaxVisuMs, Name));

        public TimeSpan Length { get; }

        /// <summary>Returns the display time of a frame that begins at <paramref name="frameStart"/>.</summary>
        public HeadsetTime LightOf(HeadsetTime frameStart) => frameStart + Length;

        /// <summary>Returns the end-to-end latency L of Eq. (1).</summary>
        public TimeSpan EndToEnd(TimeSpan application) => application + Length;
    }
}
