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
        /// Returns whether another version is compatible with this version: the major and the minor number are equal. A missing version, as before
        /// 0.2.0, and a string that is not a version count as compatible.
        /// </summary>
        public static bool Fits(string other)
        {
            var series = SeriesOf(other);
            return series == null || series == Series;
        }

        /// <summary>Returns a message to the user if the other program's version is incompatible; null if it is compatible.</summary>
        /// <param name="other">The other program's version.</param>
        /// <param name="name">Name of the other program, such as "the gateway".</param>
        /// <param name="self">Name of this program, such as "this headset".</param>
        public static string MismatchOf(string other, string name, string self) =>
            Fits(other) ? null : ConnectionMessages.OtherVersion(name, other, self, Text);

        // Returns "0.2" for "0.2.0" and for "0.2.0-rc.1"; null for a string that is not a version.
        static string SeriesOf(string version)
        {
            var match = Form.Match(version ?? "");
            return match.Success ? match.Groups[1].Value : null;
        }
    }
}
