namespace Nowpose.Cli.Messages;

/// <summary>Results and error messages of the command <c>calibrate simulate</c>.</summary>
static class SimulationMessages
{
    /// <param name="readPercent">Null if all pictures have a defect.</param>
    public static string Read(int pictures, int read, double? readPercent, int misread, double misreadMs) =>
        FormattableString.Invariant($"{pictures} pictures, {read} read ({RunTexts.Number(readPercent, "0.0", " %")} of those without a defect), ")
        + FormattableString.Invariant($"{misread} misread by more than {misreadMs} ms");

    public static string Error(double meanMs, double p95Ms) =>
        FormattableString.Invariant($"error of L_visu: mean {meanMs:0.000} ms, P95 {p95Ms:0.000} ms");

    public static string OtherPictures(string folder, int pictures, string truthFile) =>
        $"--out: {folder}: has {pictures} pictures that were not simulated ({truthFile} is missing); choose another folder";

    public static string OtherLog(string folder, string logFile, string truthFile) =>
        $"--out: {folder}: has a {logFile} that was not simulated ({truthFile} is missing); choose another folder";

    public static string Written(int pictures, string folder, string sweep, string truth) =>
        $"{pictures} pictures in {folder}, with {sweep} and {truth}";
}
