using System;
using System.Globalization;

namespace Nowpose
{
    /// <summary>Version of Nowpose, which gateway, headsets and adapters report to each other.</summary>
    static class NowposeVersion
    {
        public const string Text = "0.2.0";

        /// <summary>Maximum length of a version that another program reports.</summary>
        const int MaxLength = 32;

        static readonly string Series = SeriesOf(Text);

        /// <summary>
        /// Whether a program of that version fits this one: the major and the minor number are the same. Programs that report no version, as
        /// before 0.2.0, and texts that are no version count as fitting.
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
            Fits(other) ? null : $"{name} has version {other}, {self} has {Text}; install the same version";

        // "0.2" of "0.2.0"; null for a text that is no version.
        static string SeriesOf(string version)
        {
            if (version == null || version.Length > MaxLength) return null;
            var numbers = version.Split('.');
            return numbers.Length == 3 && Array.TrueForAll(numbers, IsNumber) ? numbers[0] + "." + numbers[1] : null;
        }

        static bool IsNumber(string text) => uint.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out _);
    }
}
