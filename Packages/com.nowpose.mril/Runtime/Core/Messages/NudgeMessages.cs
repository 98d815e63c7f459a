using System;

namespace Nowpose.Messages
{
    /// <summary>Error messages about the calibration by eye.</summary>
    static class NudgeMessages
    {
        public static string TooSlow(double mmPerS, double minMmPerS) =>
            FormattableString.Invariant($"nudge: the tool moves at {mmPerS:0} mm/s along the axis; set marks at {minMmPerS:0} mm/s or more");

        public static string OtherSpeed(double mmPerS, double earlierMmPerS) =>
            FormattableString.Invariant($"nudge: the tool moves at {mmPerS:0} mm/s, and moved at {earlierMmPerS:0} mm/s during the earlier marks; ")
            + "use the same speed, or clear the marks";

        public static string NoMark(bool isForward) => isForward
            ? "nudge: the forward direction has no mark; set marks in both directions"
            : "nudge: the backward direction has no mark; set marks in both directions";
    }
}
