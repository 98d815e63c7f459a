namespace Nowpose.Cli.Messages;

/// <summary>Labels and values in the table and the report of the command <c>demo</c>.</summary>
static class DemoTexts
{
    public const string MovingWorkpieces = "Workpieces while they move";
    public const string RotatingWorkpieces = "Rotation of these workpieces";
    public const string LargestSlip = "Largest slip of a gripped workpiece";
    public const string RenderLoadRow = "Render load";
    public const string RangeRow = "Constant-latency range";
    public const string NotFoundAgain = "not found again";
    public const string None = "none";
    public const string Published = "published";

    /// <summary>Headings of the columns in the table of errors.</summary>
    public static readonly string[] ErrorColumns = ["uncompensated", "compensated", "reduction"];

    public const string Rms = "RMS";
    public const string P95 = "P95";
    public const string MaximumRow = "maximum";
    public const string Maximum = "Maximum";

    public static string ReportTitle(string robot) => $"Nowpose demo: {robot}";
    public static string RmsFromTo(string uncompensated, string compensated) => $"{uncompensated} to {compensated} RMS";
    public static string RmsWithReduction(string from, string to, string reduction) => $"{from} to {to} RMS, reduction {reduction}";
    public static string GivenLatency(string actual, string given) => $"{actual}, the runtime uses {given}";
    public static string Fps(int framesPerSecond) => $"{framesPerSecond} fps";
    public static string Vertices(int vertices) => FormattableString.Invariant($"{vertices} vertices");

    public static string RenderLoad(double vertices, double fromSeconds, double toSeconds) =>
        FormattableString.Invariant($"{vertices} vertices, from {fromSeconds:0.0} to {toSeconds:0.0} s");

    public static string Range(string limitMs, string alarm) => $"up to {limitMs} ms; {alarm}";
    public static string FoundAgain(string seconds) => $"found again at {seconds} s";
    public static string FramesOutside(int frames) => $"{frames} frames outside";

    public static string Alarm(string leftSeconds, string found, int alarms) =>
        $"alarm: left at {leftSeconds} s, {found}" + (alarms > 1 ? $", {alarms} alarms" : "");

    public const string NoLimit = "the profile has no limit, so no alarm is raised";
    public const string NeverLeft = "never left, no alarm";

    public static string Outside(string visuMs, string insideMs, string rmsMm, string inTimeMm) =>
        $"L_visu {visuMs} ms ({insideMs} ms inside the range); error {rmsMm} mm RMS ({inTimeMm} mm in frames shown in time)";

    public const string Robot = "Robot";
    public const string Motion = "Motion";
    public const string Network = "Network";
    public const string Predictor = "Predictor";
    public const string Estimator = "Clock estimator";
    public const string SamplingInterval = "Sampling interval";
    public const string Acquisition = "Acquisition";
    public const string DisplayLatency = "Display latency";
    public const string FrameRateLabel = "Frame rate";
    public const string Load = "Load";
    public const string SetPoints = "Set-points ahead";
    public const string Seed = "Seed";
    public const string Version = "Nowpose";
    public const string DisplayTimeError = "Display time error, P95";
    public const string SynchronisedAfter = "Clock synchronised after";
    public const string AllocatedPerFrame = "Allocated per frame";
    public const string Counts = "Frames, samples, dropped";

    public const string Subtitle =
        "What the headset would have shown, compared with the true position of the simulated robot at the display time.";

    public static string Note(string text) => $"Note: {text}";
    public static string FrameRate(int framesPerSecond) => $"{framesPerSecond} fps, less under load";

    public const string MeasuredReduction = "Reduction, measured by the headset";
    public const string ApplicationLatency = "Application latency, median and P95";
    public const string ClockError = "Clock offset error, median and P95";
    public const string MaxClockError = "Clock offset error, maximum";
    public const string EstimatedClockError = "Estimated clock offset error, median; frames whose true error is within it";

    public static string EstimatedClockErrorValue(string error, string share) => $"± {error}; {share} of the frames";

    public const string FrameDuration = "Duration of a frame in the player loop, median and P99";
    public const string LatencyPlot = "Application latency L_app of each sample";

    public static string Title(string robot, string predictor, string network, bool isVirtual) =>
        $"{robot}, {predictor}, {network}{(isVirtual ? ", virtual time" : "")}: error of the tool centre point";

    public const string Time = "Time";

    /// <summary>Parts of a run in real time that virtual time does not have.</summary>
    public static readonly string[] NotInVirtualTime =
    [
        "connections over TCP and WebSocket with the pings of the gateway", "scheduling of processes and threads", "the scene",
        "processor time and memory of a frame",
    ];

    public static readonly string VirtualTime = "virtual, without " + string.Join(", ", NotInVirtualTime);

    public static readonly string VirtualSubtitle =
        "Computed in virtual time: the results depend only on the settings and the seed. They do not include: "
        + string.Join(", ", NotInVirtualTime) + ".";

    /// <summary>Headings of the columns in the table of repeats.</summary>
    public static readonly string[] RepeatColumns = ["mean", "minimum", "maximum"];

    public static string Seeds(int first, int last) =>
        FormattableString.Invariant($"seed {first}") + (first == last ? "" : FormattableString.Invariant($" to {last}"));

    public const string PickAndPlace = "pick-and-place cycle of 7-phase moves";

    public static string Recording(string file) => $"recording {file}, forward and backward";

    public const string PaperSwing = "the paper's swing of the first axis: a quarter turn and back";
}
