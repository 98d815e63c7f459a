using System.Globalization;
using System.IO;
using Nowpose.Latency.Conditions;

namespace Nowpose.Latency.Sweep
{
    /// <summary>Writes a load sweep as CSV with one row for each frame, to be joined with the pictures of a camera.</summary>
    /// <remarks>
    /// Columns: control time of the frame's start in nanoseconds, number of vertices shown, render time in milliseconds (empty if none
    /// became known in the frame), its source, device, display rate (empty if unknown). Above the header, lines "# field: value" hold
    /// the other known conditions; versions before 0.2 cannot read a log with such lines.
    /// </remarks>
    static class SweepLog
    {
        public const string Header = "control_ns,vertices,render_ms,source,device,display_hz";

        static readonly char[] Special = { ',', '"', '\r', '\n' };
        static readonly CultureInfo Culture = CultureInfo.InvariantCulture;

        internal const string ConditionPrefix = "# ", ConditionSeparator = ": ";

        public static void WriteHeader(TextWriter to) => to.Write(Header + "\n");

        /// <param name="conditions">Conditions of the sweep. The device and the display rate are in the rows.</param>
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
            to.Write(LatencyNames.RenderTimeSource.NameOf(row.Source));
            to.Write(',');
            to.Write(Quoted(row.Device));
            to.Write(',');
            if (!double.IsNaN(row.DisplayHz)) to.Write(row.DisplayHz.ToString("0.###", Culture));
            to.Write('\n');
        }

        // Line breaks become spaces so that each row is one line, even for readers that do not support quotes.
        static string Quoted(string device)
        {
            if (device.IndexOfAny(Special) < 0) return device;
            return '"' + device.Replace("\"", "\"\"").Replace('\r', ' ').Replace('\n', ' ') + '"';
        }
    }
}
