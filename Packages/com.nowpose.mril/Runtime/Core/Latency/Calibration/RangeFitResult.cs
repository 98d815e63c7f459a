using System;

namespace Nowpose.Latency.Calibration
{
    /// <summary>The constant-latency range as <see cref="RangeFit"/> found it.</summary>
    sealed class RangeFitResult
    {
        internal RangeFitResult(double visuMs, double spreadMs, double validToMs, bool isReached, int pairs, int used, int rejected, double? openToMs)
        {
            VisuMs = visuMs;
            SpreadMs = spreadMs;
            ValidToRenderMs = validToMs;
            LimitRenderMs = isReached ? validToMs : (double?)null;
            Pairs = pairs;
            Used = used;
            Rejected = rejected;
            OpenToRenderMs = openToMs;
        }

        /// <summary>L_visu: mean within the range, misread pictures apart, ms.</summary>
        public double VisuMs { get; }

        /// <summary>Standard deviation of a single picture's L_visu within the range, ms.</summary>
        public double SpreadMs { get; }

        /// <summary>The greatest render time with constant L_visu, ms; null when the loads did not reach it.</summary>
        public double? LimitRenderMs { get; }

        /// <summary>The limit, or the greatest render time at which L_visu was seen to be constant, ms.</summary>
        public double ValidToRenderMs { get; }

        /// <summary>Pairs in all.</summary>
        public int Pairs { get; }

        /// <summary>Pairs that L_visu and its spread are of: within the range, and the plateau's.</summary>
        public int Used { get; }

        /// <summary>Pairs within the range whose L_visu is not the plateau's: misread pictures, and frames that waited behind a slow one.</summary>
        public int Rejected { get; }

        /// <summary>
        /// The limit may lie anywhere up to here, ms, for in between there are no pictures; null where they are close enough, within 5 %,
        /// or no limit was reached.
        /// </summary>
        public double? OpenToRenderMs { get; }
    }
}
