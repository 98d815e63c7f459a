namespace Nowpose.Messages
{
    /// <summary>Messages about display conditions that differ from those of the calibration, and error messages about invalid conditions.</summary>
    static class ConditionMessages
    {
        public static string OtherDevice(string calibrated, string actual) =>
            $"latency profile was measured on device '{calibrated}', but this device is '{actual}'; calibrate this device";

        public static string OtherRate(string calibrated, string actual) =>
            $"latency profile was measured at {calibrated} Hz, but this display runs at {actual} Hz; calibrate at this refresh rate";

        public static string Other(string label, string calibrated, string actual, string place) =>
            $"latency profile was measured with {label} '{calibrated}', but this device has '{actual}'; calibrate again, or restore "
            + $"the setting ({place})";

        public const string PlaceOfQuality = "Project Settings, Graphics and Quality";
        public const string PlaceOfOpenXr = "Project Settings, XR Plug-in Management, OpenXR";
        public const string PlaceOfReprojection = "the component or script that sets the reprojection mode";

        public static string NotOneLine(string field, string what, int max) => $"{field}: {what} must be one line of up to {max} characters";

        public static string NotARate(string field, string text) =>
            $"{field}: '{text}' is not a number; write the refresh rate in Hz, for example 60";

        public static string NotASwitch(string field, string text, string on, string off) => $"{field}: '{text}' is not allowed; use {on} or {off}";
        public static string NotAMode(string field, string text, string allowed) => $"{field}: '{text}' is not allowed; use one of {allowed}";
    }
}
