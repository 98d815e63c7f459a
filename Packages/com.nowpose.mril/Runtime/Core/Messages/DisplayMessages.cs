using System;
using System.Globalization;
using Nowpose.Latency;
using Nowpose.Session;

namespace Nowpose.Messages
{
    /// <summary>Messages about display problems. Each message contains the action to take.</summary>
    static class DisplayMessages
    {
        const string Implausible = "display times of the runtime are implausible";

        const string WhatToDo =
            "The calibrated L_visu is used. Restart the application; if it happens again, disable the component Display Time, and report the line "
            + "about the performance counter in the log";

        const string Warning = Implausible + "; " + WhatToDo;

        const string LongerThanRefresh =
            "the display's GPU time is above its refresh interval, so that the latency is longer than L_visu by an unknown amount; draw less";

        const string LowFrameRate =
            "frames miss refreshes of the display, so that the latency is longer than L_visu by an unknown amount; draw less, shorten your scripts, "
            + "and end recording or streaming";

        const string BeyondMeasured =
            "the render time is above the longest of the latency profile, so that L_visu is unknown; draw less, or calibrate with this load";

        const string OtherSource =
            "the limit of the render time was found with another source, so that it is not monitored; calibrate again with the source in use";

        const string NoRenderTime = "the render time is not measured, so that its limit is not monitored; add the component Render Time Source, or calibrate again on this device";

        /// <param name="length">Time since the start of the newest frame.</param>
        public static string NoFrames(TimeSpan length) =>
            $"no frame has been computed for {length.TotalSeconds.ToString("0", CultureInfo.InvariantCulture)} s; if it goes on, restart the application";

        /// <summary>Returns the message about implausible display times, with the newest value; allocates.</summary>
        /// <param name="ahead">Display time minus the frame's start; null if it is no longer known.</param>
        public static string ImplausibleTimes(TimeSpan? ahead) => ahead.HasValue
            ? Implausible + ": " + ahead.Value.TotalMilliseconds.ToString("0.#", CultureInfo.InvariantCulture)
                + " ms after the start of the frame; allowed: 0 to 500 ms. " + WhatToDo
            : Warning;

        /// <summary>Returns a message about the current display problem. Allocates nothing.</summary>
        /// <param name="statistics">Statistics of the session; null without a session.</param>
        /// <returns>Null if nothing is wrong.</returns>
        public static string ProblemOf(SessionStatistics statistics)
        {
            if (statistics == null) return null;
            return statistics.OwnRobot.SampleProblem
                ?? (statistics.IsDisplayTimeImplausible ? Warning : DepthSubmissionMessages.ProblemOf(statistics.DepthSubmission))
                ?? (IsMismatched(statistics) ? statistics.ProfileMismatches[0].Words : null) ?? ProblemOf(statistics.RangeUnknownReason, statistics.IsLightPredicted);
        }

        // Except at a low frame rate, the pose stays current in these cases, because the difference from the calibrated L_visu is unknown, and may be
        // zero. A limit is not needed while the runtime predicts the display times.
        static string ProblemOf(RangeUnknownReason reason, bool isPredicted)
        {
            switch (reason)
            {
                case RangeUnknownReason.LongerThanRefresh: return LongerThanRefresh;
                case RangeUnknownReason.LowFrameRate: return LowFrameRate;
                case RangeUnknownReason.BeyondMeasured: return BeyondMeasured;
                case RangeUnknownReason.OtherSource when !isPredicted: return OtherSource;
                case RangeUnknownReason.NoRenderTime when !isPredicted: return NoRenderTime;
                default: return null;
            }
        }

        /// <summary>Returns whether the profile in use was measured under other conditions.</summary>
        public static bool IsMismatched(SessionStatistics statistics) => statistics.ProfileMismatches.Count > 0 && !statistics.IsLightPredicted;
    }
}
