using System;
using System.Globalization;

namespace Nowpose.Editor
{
    /// <summary>Values in words, "–" for what is not known.</summary>
    static class LiveText
    {
        public const string Unknown = "–";

        public static string Ms(TimeSpan? length) => Number(length?.TotalMilliseconds, "0.00", " ms");

        public static string Mm(double? millimetres) => Number(millimetres, "0.00", " mm");

        /// <param name="fraction">0.8 for 80 %.</param>
        public static string Percent(double? fraction) => Number(100 * fraction, "0", " %");

        /// <param name="format">As for <see cref="double.ToString(string)"/>.</param>
        public static string Number(double? value, string format, string unit) =>
            value.HasValue ? value.Value.ToString(format, CultureInfo.InvariantCulture) + unit : Unknown;
    }
}
