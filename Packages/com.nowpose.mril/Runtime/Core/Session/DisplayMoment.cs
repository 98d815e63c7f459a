using Nowpose.Latency;
using Nowpose.Latency.DisplayTime;
using Nowpose.Session.Hindcast;

namespace Nowpose.Session
{
    /// <summary>Display time of one frame and its quality, the same for all robots and objects in the frame.</summary>
    readonly struct DisplayMoment
    {
        /// <param name="displayTime">Null while the clock is unsynchronised.</param>
        /// <param name="isTrusted">Whether the display time is accurate enough to show a pose as current.</param>
        /// <param name="selector">Selector that determined the display time.</param>
        /// <param name="renderTimes">Monitor of the render times of the previous frames.</param>
        /// <param name="isLast">See <see cref="IsLast"/>.</param>
        public DisplayMoment(
            HeadsetTime start, ControlTime? displayTime, in ClockModel clock, bool isTrusted, DisplayTimeSelector selector,
            ConstantLatencyMonitor renderTimes, bool isLast)
        {
            Start = start;
            DisplayTime = displayTime;
            Clock = clock;
            IsTrusted = isTrusted;
            IsLast = isLast;
            IsInconsistent = selector.IsInconsistent;
            IsImplausible = selector.IsImplausible;
            Range = renderTimes.State;
            MissesRefreshes = renderTimes.MissesRefreshes;
            ErrorWithheld = WithheldErrors.ReasonOf(renderTimes, selector.IsPredicted);
        }

        /// <summary>Start of the frame on the headset clock.</summary>
        public HeadsetTime Start { get; }

        /// <summary>Display time on the control clock; null while the clock is unsynchronised.</summary>
        public ControlTime? DisplayTime { get; }

        public ClockModel Clock { get; }

        /// <summary>Whether the display time is accurate enough to show a pose as current.</summary>
        public bool IsTrusted { get; }

        /// <summary>False if the frame is computed again before it is rendered. Such a computation is not displayed.</summary>
        public bool IsLast { get; }

        /// <summary>
        /// Whether the render time of the previous frames is in the constant-latency range, and they missed no refreshes. Only then is the
        /// display time known.
        /// </summary>
        public RangeState Range { get; }

        /// <inheritdoc cref="ConstantLatencyMonitor.MissesRefreshes"/>
        public bool MissesRefreshes { get; }

        /// <summary>See <see cref="DisplayFrame.ErrorWithheld"/>.</summary>
        public ErrorWithheldReason ErrorWithheld { get; }

        /// <summary>See <see cref="DisplayFrame.IsDisplayTimeInconsistent"/>.</summary>
        public bool IsInconsistent { get; }

        /// <summary>See <see cref="DisplayFrame.IsDisplayTimeImplausible"/>.</summary>
        public bool IsImplausible { get; }
    }
}
