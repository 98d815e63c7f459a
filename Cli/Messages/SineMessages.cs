namespace Nowpose.Cli.Messages;

/// <summary>Error messages and warnings of the command <c>calibrate sine</c>, with remedies.</summary>
static class SineMessages
{
    public static string NoBox(string option) =>
        $"{option} is missing: for a video, mark both patches in its first picture, as X,Y,WIDTH,HEIGHT in px";

    public static string BoxOutside(string option, int x, int y, int width, int height, int pictureWidth, int pictureHeight) =>
        $"{option}: {x},{y},{width},{height} px is not inside the picture of {pictureWidth}x{pictureHeight} px; choose a smaller box";

    public static string TooShort(double seconds, double maxLagSeconds) =>
        FormattableString.Invariant($"recording: {seconds:0.0} s is too short to find lags up to {maxLagSeconds} s; record at least ten ")
        + "seconds";

    public static string IntervalTooLong(double seconds, double maxSeconds) =>
        FormattableString.Invariant($"recording: the pictures are {seconds:G4} s apart; at most {maxSeconds} s are allowed; check that the time ")
        + "is in s";

    public static string NoMotion(string what) => $"recording: {what} does not move; jog a joint back and forth while it is filmed";

    public static string NoCorrelation(double correlation, double min) =>
        FormattableString.Invariant($"recording: the hologram does not follow the robot: correlation {correlation:0.00}, at least {min} is ")
        + "needed; check the columns; if their values increase in opposite directions, add --inverted";

    public static string LagOutOfRange(double lagMs, double minMs, double maxMs) =>
        FormattableString.Invariant($"recording: the lag with the best correlation is at or beyond {lagMs:0} ms; allowed: {minMs:0} to ")
        + FormattableString.Invariant($"{maxMs:0} ms; check both clocks");

    public static string VisuOutOfRange(double visuMs, double lagMs, double maxMs) =>
        FormattableString.Invariant($"L_visu is {visuMs:0.0} ms, from a lag of {lagMs:0.0} ms; allowed: 0 to {maxMs:0} ms; check that robot and ")
        + "hologram are not exchanged, and check --app-ms, --sampling-ms or --visu-ms";

    public static string Ambiguous(double periodSeconds) =>
        FormattableString.Invariant($"recording: the motion repeats after {periodSeconds:0.00} s, so the lag is ambiguous; jog more ")
        + "slowly, with a period of 2 s or more";

    public const string ReadoutOfTable =
        "--readout-ms needs a video, because a table does not contain the heights of robot and hologram; film both at the same height";

    public const string NoProfile = "no profile was written: state which part of the lag is L_visu with --app-ms or --visu-ms";

    public static string SteppedGhost(double? heldMs, double errorMs) =>
        FormattableString.Invariant($"the ghost moves every {heldMs:0.##} ms, in step with the frames of the video: the result may be wrong by ")
        + FormattableString.Invariant($"up to {errorMs:0.0} ms; film the gripper instead, with --visu-ms, or film at another frame rate");

    public static string SteadyFlashes(double picturesPerSecond, double errorMs) =>
        FormattableString.Invariant($"{picturesPerSecond:0.##} pictures a second are in step with the display: the result may be wrong by up to ")
        + FormattableString.Invariant($"{errorMs:0.0} ms; film at 25 or 50 pictures a second, or with a short exposure, stated with --exposure-ms");

    public static string StandardError(double deviationMs) =>
        FormattableString.Invariant($"the standard error is {deviationMs:0.0} ms: jog farther or faster, or film longer, to get below ± 3 ms");

    public static string ColumnsNeeded(string path, int columns) =>
        $"{path}: {columns} columns after the time; name the columns of robot and hologram with --columns ROBOT,HOLOGRAM";

    public static string SameColumn(string column) => $"--columns: '{column}' is given for both robot and hologram; name two columns";

    public static string ColumnNeeded(string path, int columns, string option) =>
        $"{path}: {columns} columns after the time; name one: {option} NAME";

    public static string UnknownColumn(string option, string path, string column, string columns) =>
        $"{option}: {path} has no column '{column}'; it has {columns}; choose one of these";

    public static string TooFewPictures(string path, int pictures, int min) =>
        FormattableString.Invariant($"{path}: {pictures} pictures show both robot and hologram; at least {min} are needed; film for ten ")
        + "seconds or more";

    public const string BothWays =
        "--app-ms and --visu-ms cannot be combined: use --app-ms if the video shows the ghost, which is not compensated, "
        + "or --visu-ms if it shows the gripper, which is";

    public static string PatchLost(string path, int picture, bool isRobot, double match, double min) => FormattableString.Invariant(
        $"{path}: picture {picture}: the {(isRobot ? "robot's" : "hologram's")} patch is lost (match {match:0.00}, at least {min} is needed); ")
        + "mark a patch with more contrast, or film a shorter motion";
}
