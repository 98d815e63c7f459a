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

        public const string NoSession = "nudge: no session is assigned; assign one";
        public const string Predicted = "nudge: the runtime predicts display times, so L_visu needs no correction";
    }
}
