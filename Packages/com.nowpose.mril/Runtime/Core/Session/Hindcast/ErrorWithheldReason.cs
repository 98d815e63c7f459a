using Nowpose.Latency;
using Nowpose.Messages;

namespace Nowpose.Session.Hindcast
{
    /// <summary>
    /// Reason why a session withholds the errors that it measures. For each reason except <see cref="MovingBase"/>, frames may appear at times other than
    /// their computed display times.
    /// </summary>
    enum ErrorWithheldReason
    {
        /// <summary>The errors are not withheld.</summary>
        None,

        /// <summary>The render time is outside the constant-latency range.</summary>
        OutsideRange,

        /// <summary>The render time is beyond the calibrated range, and the calibration found no limit in it.</summary>
        BeyondMeasured,

        /// <summary>The limit was found with another source of the render time, so late frames cannot be detected.</summary>
        OtherSource,

        /// <summary>A limit is known, but the render time is not measured, so late frames cannot be detected.</summary>
        NoRenderTime,

        /// <summary>
        /// Frames miss refreshes: no range is known, and the display's GPU time is above its refresh interval. Runtimes predict the display time of
        /// frames in time.
        /// </summary>
        LongerThanRefresh,

        /// <summary>
        /// Frames miss refreshes, because their rate is too low. The errors of the run leave these frames out, because the rate always shows them.
        /// </summary>
        LowFrameRate,

        /// <summary>
        /// The base of the robot moves, and the errors of its pose are not measured. Withholds only the errors of the tool, not those of the joints.
        /// </summary>
        MovingBase,
    }

    /// <summary>Determines why errors are withheld, and describes the reason.</summary>
    static class WithheldErrors
    {
        /// <param name="isPredicted">Whether the runtime predicts the display times. Predicted display times do not depend on the profile.</param>
        public static ErrorWithheldReason ReasonOf(ConstantLatencyMonitor renderTimes, bool isPredicted)
        {
            switch (renderTimes.UnknownReason)
            {
                case RangeUnknownReason.BeyondMeasured: return ErrorWithheldReason.BeyondMeasured;
                case RangeUnknownReason.LongerThanRefresh: return ErrorWithheldReason.LongerThanRefresh;
                case RangeUnknownReason.LowFrameRate: return ErrorWithheldReason.LowFrameRate;
                case RangeUnknownReason.OtherSource when !isPredicted: return ErrorWithheldReason.OtherSource;
                case RangeUnknownReason.NoRenderTime when !isPredicted: return ErrorWithheldReason.NoRenderTime;
                default: return renderTimes.State == RangeState.Outside ? ErrorWithheldReason.OutsideRange : ErrorWithheldReason.None;
            }
        }

        /// <summary>Returns the reason as text; null for <see cref="ErrorWithheldReason.None"/>.</summary>
        public static string WordsOf(ErrorWithheldReason reason)
        {
            switch (reason)
            {
                case ErrorWithheldReason.OutsideRange: return "outside range";
                case ErrorWithheldReason.BeyondMeasured: return StateNames.BeyondMeasured;
                case ErrorWithheldReason.OtherSource: return StateNames.OtherSourceLimit;
                case ErrorWithheldReason.NoRenderTime: return StateNames.RenderTimeNotMeasured;
                case ErrorWithheldReason.LongerThanRefresh:
                case ErrorWithheldReason.LowFrameRate: return StateNames.FramesMissRefreshes;
                case ErrorWithheldReason.MovingBase: return StateNames.MovingBase;
                default: return null;
            }
        }
    }
}
