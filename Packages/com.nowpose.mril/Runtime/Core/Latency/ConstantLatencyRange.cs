using System;
using Nowpose.Messages;

namespace Nowpose.Latency
{
    /// <summary>The render times of one device for which L_visu is constant. Immutable; validated by the constructor.</summary>
    /// <remarks>Schnierle &amp; Röck 2022, Fig. 11b.</remarks>
    public sealed class ConstantLatencyRange
    {
        /// <param name="limitMs">Maximum render time with constant L_visu: 0.1 to 1000 ms.</param>
        /// <param name="source">Source of the render times with which the limit was found.</param>
        /// <param name="isLimitReached">Value of <see cref="IsLimitReached"/>.</param>
        /// <exception cref="InputException">The limit is out of range, or the source is missing.</exception>
        public ConstantLatencyRange(double limitMs, RenderTimeSourceKind source, bool isLimitReached = true)
        {
            IsLimitReached = isLimitReached;
            Limit = SettingRange.RequireMs(limitMs, 0.1, 1000, "render time limit");
            if (source == RenderTimeSourceKind.None)
                throw new InputException(ProfileMessages.LimitWithoutSource);
            Source = source;
        }

        public TimeSpan Limit { get; }

        public RenderTimeSourceKind Source { get; }

        /// <summary>
        /// Whether L_visu is known to be longer beyond the limit. False if the calibration did not exceed the limit, so that L_visu is unknown
        /// beyond it.
        /// </summary>
        public bool IsLimitReached { get; }
    }
}
