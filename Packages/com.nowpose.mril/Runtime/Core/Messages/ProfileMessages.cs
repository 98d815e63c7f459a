using System;

namespace Nowpose.Messages
{
    /// <summary>Error messages about latency profiles. The reader adds the name of the file.</summary>
    static class ProfileMessages
    {
        public const string LimitWithoutSource = "render time limit: state the source of the render times from which it was determined";

        public static string OtherFormat(string format, string expected) =>
            $"it is not a latency profile: its format is '{format}', not '{expected}'; choose a file that calibrate has written";

        public static string NewerVersion(int version, int max) =>
            $"the latency profile has version {version}; this release of Nowpose reads versions up to {max}; update Nowpose or calibrate again";

        public static string Version(int version, int allowed) => $"version: {version} is not supported; allowed: {allowed}; calibrate again";
        public static string Missing(string field) => $"{field} is missing; calibrate again";
        public static string Twice(string field) => $"{field} occurs twice; remove one";
        public static string UnknownSource(string name, string allowed) => $"render_source: '{name}' is unknown; allowed: {allowed}";
        public static string UnknownMethod(string name, string allowed) => $"method: '{name}' is unknown; allowed: {allowed}";

        public const string NotComplete = "it is not a complete JSON object; calibrate again";

        /// <summary>Describes, in a message, a value that is an object, a list or a Boolean.</summary>
        public const string OtherKind = "neither a string nor a number";

        public static string NotANumber(string field, string value, double min, double max, string unit) => FormattableString.Invariant(
            $"{field} is {value}; it must be a number from {min} to {max}{unit}; calibrate again");
        public static string NotWhole(string field, double value) => FormattableString.Invariant(
            $"{field} is {value}; it must be a whole number; calibrate again");
        public static string NotAText(string field, string value) => $"{field} is {value}; it must be a string; calibrate again";
        public static string NotADate(string field, string text) => $"{field}: '{text}' is not a date; write it as 2026-11-20T13:00:00Z";
    }
}
