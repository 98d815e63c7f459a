using Nowpose.Sync;

namespace Nowpose.Cli.Messages;

/// <summary>Lines that commands print to stderr in addition to their result.</summary>
static class ConsoleMessages
{
    public static string Line(string text) => $"nowpose: {text}";
    public static string Picture(string file, string fault) => $"nowpose: {file}: {fault}";

    /// <param name="total">Null if it is unknown.</param>
    public static string Progress(int done, int? total, string units) => total is int all ? $"{done} of {all} {units}" : $"{done} {units}";

    public static string Repeat(int repeat, int repeats) => $"repeat {repeat} of {repeats}";
    public static string CalibrationInterrupted(string path) => $"nowpose: the calibration was interrupted; {path} shows the pictures so far";
    public static string NotOpened(string reason, string path) => $"nowpose: --open: {reason}; open {path} in a browser";

    public const string NoDesktop = "this machine has no desktop (DISPLAY and WAYLAND_DISPLAY are not set)";

    public static string DesktopFailed(string reason) => $"the desktop could not open the page: {reason}";

    public static string ProfileKept(string path, double limitMs) =>
        FormattableString.Invariant($"nowpose: {path} has a render time limit of {limitMs:0.00} ms and was kept; the new profile has no ")
        + "limit and was written beside it. To keep the limit with the new L_visu, run calibrate vlc, sine or nudge with --profile "
        + FormattableString.Invariant($"{path}");

    public static string FfmpegReports(string path, int pictures, string report) =>
        $"nowpose: {path}: {pictures} pictures were read, but ffmpeg reports: {report}";

    public static string MoreRejected(int count) => $"nowpose: {count} more pictures were rejected";

    public static string LostLines(string path, long lines) =>
        Line($"{path}: {SessionFileMessages.LinesLost(lines)}");

    public static string DroppedExchanges(string file, int dropped, int exchanges, SyncExchangeFault fault) =>
        Line($"{file}: dropped {dropped} of {exchanges} exchanges: {fault}; {ExchangeFileMessages.Remedy(fault)}");

    public static string ClockSteps(string file, int steps) => $"nowpose: {file}: {steps} clock steps detected";
    public static string WouldFail(string reason) => $"nowpose: without --check this would fail: {reason}";
}
