using System;
using System.Globalization;
using Nowpose.Latency;
using Nowpose.Latency.Profile;

namespace Nowpose.Unity.Messages
{
    /// <summary>Messages about a calibration, for the status panel and the console.</summary>
    static class LatencyProfileMessages
    {
        public static string Of(CalibrationMethod method)
        {
            switch (method)
            {
                case CalibrationMethod.VisibleLight: return "by visible light";
                case CalibrationMethod.Sine: return "by sine jog";
                case CalibrationMethod.Nudge: return "by eye";
                default: return "by hand";
            }
        }

        /// <summary>Returns the method and the date of a calibration as one string.</summary>
        public static string OriginOf(LatencyProfile profile) =>
            Of(profile.Method) + ", " + profile.MeasuredUtc.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture);

        /// <summary>Returns a summary of a calibration in one line.</summary>
        public static string Of(LatencyProfile profile) => string.Format(
            CultureInfo.InvariantCulture, "L_visu {0:0.0} ms ± {1:0.0} ms {2}; {3}", profile.Visualisation.Length.TotalMilliseconds,
            profile.Spread.TotalMilliseconds, OriginOf(profile), RangeOf(profile));

        /// <param name="origin">Place of the profile.</param>
        public static string Loaded(LatencyProfile profile, string origin) => $"latency profile: {Of(profile)}; from {origin}";

        static string RangeOf(LatencyProfile profile)
        {
            if (profile.Range is { } range)
                return FormattableString.Invariant($"up to {range.Limit.TotalMilliseconds:0.0} ms render time, {RenderTimeNames.NameOf(range.Source)}");
            return profile.ValidToRenderTime is { } valid
                ? FormattableString.Invariant($"no limit found up to {valid.TotalMilliseconds:0.0} ms render time") : "no render time limit known";
        }
    }
}
