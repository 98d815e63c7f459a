using System;
using System.Globalization;

namespace Nowpose.Messages
{
    /// <summary>Short labels for the states of joints, of other parts of the cell, and of measured values.</summary>
    static class StateNames
    {
        public const string OtherSourceLimit = "limit is for another source";
        public const string BeyondMeasured = "beyond measured range";
        public const string FramesMissRefreshes = "frames miss refreshes";
        public const string MovingBase = "moving base";
        public const string RenderTimeNotMeasured = "render time not measured";
        public const string ValuesUnusable = "no usable values";

        /// <summary>Start of the gateway's reason for a joint that may not be at rest. The text is part of the protocol.</summary>
        public const string UncertainRestReason = "may not be at rest: ";

        /// <summary>State of an object or a signal.</summary>
        public const string NotCurrent = "not current";

        /// <summary>Returns for example "no data for 4 s: node deleted".</summary>
        /// <param name="age">Time since the state began; null if unknown.</param>
        /// <param name="reason">Null or empty if unknown.</param>
        public static string Describe(string state, TimeSpan? age, string reason) =>
            Describe(state, age.HasValue ? " for " + TextOf(age.Value) : "", reason);

        /// <param name="time">Time as text with a leading space; may be empty.</param>
        public static string Describe(string state, string time, string reason) => state + time + (string.IsNullOrEmpty(reason) ? "" : ": " + reason);

        // Formats a duration in whole seconds, minutes or hours.
        static string TextOf(TimeSpan length)
        {
            if (length.TotalSeconds < 120) return Text(length.TotalSeconds) + " s";
            return length.TotalMinutes < 120 ? Text(length.TotalMinutes) + " min" : Text(length.TotalHours) + " h";
        }

        static string Text(double number) => Math.Floor(number).ToString(CultureInfo.InvariantCulture);
    }
}
