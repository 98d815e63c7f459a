using System;

namespace Nowpose.Unity.Messages
{
    /// <summary>Error messages and results of the calibration by eye.</summary>
    static class NudgeReports
    {
        public const string NotSteady = "nudge: the tool does not move steadily; set marks while it moves at constant speed";

        public static string Result(double visuMs, double spreadMs, int marks, double offsetMm, NudgeAxis axis) =>
            FormattableString.Invariant($"nudge: L_visu {visuMs:0.0} ms ± {spreadMs:0.0} ms from {marks} marks; the base is misplaced by ")
            + FormattableString.Invariant($"{offsetMm:0.0} mm along {axis}");

        public static string Progress(double shiftMm, NudgeAxis axis, int forward, int backward) =>
            FormattableString.Invariant($"nudge: {shiftMm:0.0} mm along {axis}; marks: {forward} forward, {backward} backward");

        public const string Disabled = "nudge: the component is switched off; enable Latency Nudge";
        public const string NoSession = "nudge: no session is assigned; assign one";
        public const string NotRunning = "nudge: the session is paused, or has not started; try again when it runs";

        public const string Predicted =
            "nudge: the runtime predicts display times, so L_visu has no effect; disable Display Time during the calibration";
    }
}
