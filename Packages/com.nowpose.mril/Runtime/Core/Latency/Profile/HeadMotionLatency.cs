using System;
using Nowpose.Messages;

namespace Nowpose.Latency.Profile
{
    /// <summary>Latency with which the image follows head motion. Late-stage reprojection reduces it.</summary>
    /// <remarks>L_visu is the age of the content, which late-stage reprojection does not change.</remarks>
    sealed class HeadMotionLatency
    {
        internal const double MinMs = -500, MaxMs = 500;

        /// <param name="latencyMs">−500 to 500 ms; negative when the image is ahead of the head.</param>
        /// <param name="uncertaintyMs">Half of the 95 % confidence interval, 0 to 500 ms.</param>
        /// <exception cref="InputException">A value is out of range.</exception>
        public HeadMotionLatency(double latencyMs, double uncertaintyMs)
        {
            Latency = SettingRange.RequireMs(latencyMs, MinMs, MaxMs, "head motion latency");
            Uncertainty = SettingRange.RequireMs(uncertaintyMs, 0, MaxMs, SettingNames.HeadMotionUncertainty);
        }

        /// <summary>Delay of the image behind the head; negative if the image is ahead.</summary>
        public TimeSpan Latency { get; }

        /// <summary>Half of the 95 % confidence interval.</summary>
        public TimeSpan Uncertainty { get; }
    }
}
