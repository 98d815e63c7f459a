using System.Globalization;
using System.IO;

namespace Nowpose.Latency
{
    /// <summary>Writes a load sweep as CSV: one row for each frame, to be joined with the pictures of a camera.</summary>
    /// <remarks>
    /// The columns: control time of the frame's start in nanoseconds, vertices shown, render time in milliseconds (empty when none
    /// became known in the frame), what measured it, device, display rate (empty when unknown).
    /// </remarks>
    public static class SweepLog
    {
        public const string Header = "control_ns,vertices,render_ms,source,device,display_hz";

        static readonly char[] Special = { ',', '"', '\r', '\n' };
        static readonly CultureInfo Culture = CultureInfo.InvariantCulture;

        public static void WriteHeader(TextWriter to) => to.Write(Header + "\n");

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
