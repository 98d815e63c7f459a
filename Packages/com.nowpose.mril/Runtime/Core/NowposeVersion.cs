using System.Text.RegularExpressions;
using Nowpose.Messages;

namespace Nowpose
{
    /// <summary>Version of Nowpose, which gateway, headsets and adapters report to each other.</summary>
    static class NowposeVersion
    {
        public const string Text = "0.2.0";

        // Three numbers, then optionally a pre-release and a build, which are not compared.
        static readonly Regex Form = new Regex(@"^([0-9]{1,9}\.[0-9]{1,9})\.[0-9]{1,9}([-+][0-9A-Za-z.+-]{1,64})?\z");

        static readonly string Series = SeriesOf(Text);

        /// <summary>
        /// Whether a program of that version fits this one: the major and the minor number are the same. Programs that report no version, as
        /// before 0.2.0, and texts that are not versions count as fitting.
        /// </summary>
        public static bool Fits(string other)
        {
            var series = SeriesOf(other);
            return series == null || series == Series;
        }

        /// <summary>Gets a sentence for the user if the other program does not fit; null if it does.</summary>
        /// <param name="other">The other program's version.</param>
        /// <param name="name">Name of the other program, such as "the gateway".</param>
        /// <param name="self">Name of this program, such as "this headset".</param>
        public static string MismatchOf(string other, string name, string self) =>
            Fits(other) ? null : ConnectionMessages.OtherVersion(name, other, self, Text);

        // "0.2" of "0.2.0" and of "0.2.0-rc.1"; null for a text that is not a version.
        static string SeriesOf(string version)
        {
            var match = Form.Match(version ?? "");
            return match.Success ? match.Groups[1].Value : null;
        }
    }
}
