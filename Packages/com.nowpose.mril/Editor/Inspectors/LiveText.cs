using System;
using System.Globalization;
using Nowpose.Unity;

namespace Nowpose.Editor
{
    /// <summary>Values in words, "–" for what is not known.</summary>
    static class LiveText
    {
        public const string Unknown = NumberTexts.Unknown;

        public static string Ms(TimeSpan? length) => Number(length?.TotalMilliseconds, "0.00", " ms");

        public static string Mm(double? millimetres) => Number(millimetres, "0.00", " mm");

        /// <param name="format">As for <see cref="double.ToString(string)"/>.</param>
        public static string Number(double? value, string format, string unit) =>
            value.HasValue ? value.Value.ToString(format, CultureInfo.InvariantCulture) + unit : Unknown;
    }
}
