using System;
using Nowpose.Messages;

namespace Nowpose
{
    /// <summary>
    /// Checks settings. The message of an error is one line with the name of the setting, its value and unit, and the allowed range.
    /// </summary>
    static class SettingRange
    {
        /// <param name="unit">Unit of the value; empty for a value without a unit.</param>
        /// <exception cref="InputException">The value is out of range or not a number.</exception>
        public static double Require(double value, double min, double max, string name, string unit)
        {
            if (value >= min && value <= max) return value;
            throw new InputException(SettingMessages.OutOfRange(name, value, Suffix(unit), min, max));
        }

        /// <summary>Returns the unit with a leading space, to be appended to a value; empty for a value without unit.</summary>
        public static string Suffix(string unit) => unit.Length == 0 ? "" : " " + unit;

        /// <inheritdoc cref="Require"/>
        public static int RequireCount(long value, int min, int max, string name) => (int)Require(value, min, max, name, "");

        /// <inheritdoc cref="Require"/>
        public static TimeSpan RequireMs(double ms, double min, double max, string name) =>
            ClockTicks.Span(Require(ms, min, max, name, "ms") / 1000);

        /// <inheritdoc cref="Require"/>
        public static TimeSpan RequireSeconds(double seconds, double min, double max, string name) =>
            ClockTicks.Span(Require(seconds, min, max, name, "s"));
    }
}
