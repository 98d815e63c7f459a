using System.Globalization;
using System.IO;
using Nowpose.Latency.Conditions;

namespace Nowpose.Latency.Sweep
{
    /// <summary>Writes a load sweep as CSV: one row for each frame, to be joined with the pictures of a camera.</summary>
    /// <remarks>
    /// The columns: control time of the frame's start in nanoseconds, vertices shown, render time in milliseconds (empty when none
    /// became known in the frame), what measured it, device, display rate (empty when unknown). Above the header, lines "# field: value"
    /// hold the other conditions that are known; readers of versions before 0.2 refuse a log with such lines.
    /// </remarks>
    static class SweepLog
    {
        public const string Header = "control_ns,vertices,render_ms,source,device,display_hz";

        static readonly char[] Special = { ',', '"', '\r', '\n' };
        static readonly CultureInfo Culture = CultureInfo.InvariantCulture;

        internal const string ConditionPrefix = "# ", ConditionSeparator = ": ";

        public static void WriteHeader(TextWriter to) => to.Write(Header + "\n");

        /// <param name="conditions">Those of the sweep. Device and rate are in the rows.</param>
        public static void WriteHeader(TextWriter to, DisplayConditions conditions)
        {
            for (var condition = DisplayCondition.GraphicsApi; condition <= DisplayCondition.Reprojection; condition++)
                if (conditions[condition] != null)
                    to.Write(ConditionPrefix + DisplayConditionNames.FieldOf(condition) + ConditionSeparator + conditions[condition] + "\n");
            WriteHeader(to);
        }

        public static void Write(TextWriter to, in SweepRow row)
        {
            to.Write(row.FrameStart.Nanoseconds.ToString(Culture));
            to.Write(',');
            to.Write(row.Vertices.ToString(Culture));
            to.Write(',');
            if (row.RenderMs is double ms) to.Write(ms.ToString("0.####", Culture));
            to.Write(',');
            to.Write(RenderTimeSourceNames.NameOf(row.Source));
            to.Write(',');
            to.Write(Quoted(row.Device));
            to.Write(',');
            if (!double.IsNaN(row.DisplayHz)) to.Write(row.DisplayHz.ToString("0.###", Culture));
            to.Write('\n');
        }

        // Rows are lines, also to whoever reads them without knowing of quotes.
        static string Quoted(string device)
        {
            if (device.IndexOfAny(Special) < 0) return device;
            return '"' + device.Replace("\"", "\"\"").Replace('\r', ' ').Replace('\n', ' ') + '"';
        }
    }
}
