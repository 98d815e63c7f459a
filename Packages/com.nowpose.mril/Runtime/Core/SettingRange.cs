using System;
using System.Globalization;

namespace Nowpose
{
    /// <summary>Checks settings. An error is one line with the name, the value with its unit, and what is allowed.</summary>
    static class SettingRange
    {
        /// <param name="unit">Empty for a value without unit.</param>
        /// <exception cref="InputException">The value is out of range or not a number.</exception>
        public static double Require(double value, double least, double greatest, string name, string unit)
        {
            if (value >= least && value <= greatest) return value;
            var suffix = unit.Length == 0 ? "" : " " + unit;
            throw new InputException(string.Format(
                CultureInfo.InvariantCulture, "{0}: {1}{4} is out of range; allowed are {2} to {3}{4}", name, value, least, greatest, suffix));
        }

        /// <inheritdoc cref="Require"/>
        public static int RequireCount(int value, int least, int greatest, string name) => (int)Require(value, least, greatest, name, "");

        /// <inheritdoc cref="Require"/>
        public static TimeSpan RequireMs(double ms, double least, double greatest, string name) =>
            ClockTicks.Span(Require(ms, least, greatest, name, "ms") / 1000);

        /// <inheritdoc cref="Require"/>
        public static TimeSpan RequireSeconds(double seconds, double least, double greatest, string name) =>
            ClockTicks.Span(Require(seconds, least, greatest, name, "s"));
    }
}
