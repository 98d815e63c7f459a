using System;

namespace Nowpose.Latency
{
    /// <summary>The render times up to which L_visu is constant, of one device. Immutable, checked once.</summary>
    /// <remarks>Schnierle &amp; Röck 2022, Fig. 11b.</remarks>
    public sealed class ConstantLatencyRange
    {
        /// <param name="limitMs">The greatest render time with constant L_visu: 0.1 to 1000 ms.</param>
        /// <param name="source">What the render time was measured with when the limit was found.</param>
        /// <param name="isLimitReached">As <see cref="IsLimitReached"/>.</param>
        /// <exception cref="InputException">Out of range, or no source.</exception>
        public ConstantLatencyRange(double limitMs, RenderTimeSourceKind source, bool isLimitReached = true)
        {
            IsLimitReached = isLimitReached;
            Limit = SettingRange.RequireMs(limitMs, 0.1, 1000, "render time limit");
            if (source == RenderTimeSourceKind.None)
                throw new InputException("render time limit: say which source of the render time it was found with; it holds for no other");
            Source = source;
        }

        public TimeSpan Limit { get; }

        public RenderTimeSourceKind Source { get; }

        /// <summary>
        /// Whether L_visu is longer beyond the limit. Else no calibration went beyond it, and nobody knows what L_visu is there.
        /// </summary>
        public bool IsLimitReached { get; }
    }
}
