namespace Nowpose.Cli.Messages;

/// <summary>Labels and values in the table and the report of the command <c>demo</c>.</summary>
static class DemoTexts
{
    public const string MovingWorkpieces = "workpieces while they move";
    public const string RotatingWorkpieces = "rotation of these workpieces";
    public const string LateFrames = "frames that began late";

    public static string LateFramesValue(int late, int frames, double maxMs) =>
        FormattableString.Invariant($"{late} of {frames}, by up to {maxMs:0} ms: this machine was busy, which increased delays and errors");

    public const string NoLimit = "the profile has no limit, so no alarm is raised";
    public const string NeverLeft = "never left, no alarm";

    public static string Outside(string visuMs, string insideMs, string rmsMm, string inTimeMm) =>
        $"L_visu {visuMs} ms ({insideMs} ms inside the range); error {rmsMm} mm RMS ({inTimeMm} mm in frames shown in time)";

    public const string Subtitle =
        "What the headset would have shown, compared with the true position of the simulated robot at the display time.";

    public static string FrameRate(int framesPerSecond) => $"{framesPerSecond} fps, less under load";

    public const string MeasuredReduction = "Reduction, measured by the headset";
    public const string ApplicationLatency = "Application latency, median and P95";
    public const string ClockError = "Clock offset error, median and P95";
    public const string MaxClockError = "Clock offset error, maximum";
    public const string EstimatedClockError = "Estimated clock offset error, median; frames whose true error is within it";

    public static string EstimatedClockErrorValue(string errorUs, string sharePercent) => $"± {errorUs} µs; {sharePercent} % of the frames";

    public const string FrameDuration = "Duration of a frame in the player loop, median and P99";
    public const string LatencyPlot = "Application latency L_app of each sample";

    public static string Title(string robot, string predictor, string network) =>
        $"{robot}, {predictor}, {network}: error of the tool centre point";

    public const string AsMeasured = "measured by the headset";
    public const string EstimatedClockErrorRow = "estimated clock offset error";

    public static string EstimatedClockErrorMedian(string error, string share) =>
        $"± {error} median, true error within it in {share} of the frames";

    public const string FrameRow = "frame in the player loop";
    public const string PickAndPlace = "pick-and-place cycle of 7-phase moves";

    public static string Recording(string file) => $"recording {file}, forward and backward";

    public const string PaperSwing = "the paper's swing of the first axis: a quarter turn and back";
}
