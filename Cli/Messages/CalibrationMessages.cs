namespace Nowpose.Cli.Messages;

/// <summary>Error messages and warnings of the command <c>calibrate</c> about options and profiles, with remedies.</summary>
static class CalibrationMessages
{
    public static string OtherSweep(string label, string calibrated, string actual) =>
        $"--sweep: the log was written with {label} '{calibrated}', but the options state '{actual}'; the pictures must show this sweep: "
        + "correct the options, or repeat the sweep and its pictures with the same settings";

    public static string OtherProfile(string path, string label, string calibrated, string actual) =>
        $"--profile: {path} was measured with {label} '{calibrated}', but this measurement has '{actual}'; the values that are kept from the "
        + "profile may be wrong: repeat the load sweep";

    public const string Interrupted =
        "the measurement was interrupted, so the result and the other warnings are those of the pictures so far; run it again";

    public const string NoSpeed = "--speed-mm-s is missing; allowed: 1 to 10000 mm/s";

    public static string NoOffset(string option) => $"{option} is missing; give at least one offset for each direction of motion";

    public static string BothNames(string former, string present) => $"{former} is the former name of {present}; use only {present}.";
}
