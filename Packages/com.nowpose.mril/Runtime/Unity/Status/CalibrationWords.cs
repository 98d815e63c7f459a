using System.Globalization;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Unity.Rendering;

namespace Nowpose.Unity.Status
{
    /// <summary>Texts about a calibration, for the status panel and the console.</summary>
    static class CalibrationWords
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

        /// <summary>Returns the method and the date of a calibration.</summary>
        public static string OriginOf(LatencyProfile profile) =>
            Of(profile.Method) + ", " + profile.MeasuredUtc.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture);

        /// <summary>Returns a summary of a calibration in one line.</summary>
        public static string Of(LatencyProfile profile) => string.Format(
            CultureInfo.InvariantCulture, "L_visu {0:0.0} ms ± {1:0.0} ms {2}; {3}", profile.Visualisation.Length.TotalMilliseconds,
            profile.Spread.TotalMilliseconds, OriginOf(profile), RangeOf(profile));

        static string RangeOf(LatencyProfile profile)
        {
            if (profile.Range != null) return Ms("up to {0:0.0} ms render time, ", profile.Range.Limit.TotalMilliseconds) + RenderTimeWords.NameOf(profile.Range.Source);
            return profile.ValidToRenderTime.HasValue
                ? Ms("no limit seen up to {0:0.0} ms render time", profile.ValidToRenderTime.Value.TotalMilliseconds) : "no render time limit known";
        }

        static string Ms(string format, double ms) => string.Format(CultureInfo.InvariantCulture, format, ms);
    }
}
