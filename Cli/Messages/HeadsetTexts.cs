namespace Nowpose.Cli.Messages;

/// <summary>Labels and values in the table of the command <c>headset</c>.</summary>
static class HeadsetTexts
{
    public const string Versions = "versions";
    public const string ClockRow = "clock";
    public const string CoarseAfter = "coarse after";
    public const string SynchronisedAfter = "synchronised after";
    public const string ClockSteps = "clock steps";
    public const string ApplicationLatency = "application latency";
    public const string VisualisationLatency = "visualisation latency, configured";
    public const string EndToEndLatency = "end-to-end latency";
    public const string PoseRow = "pose";
    public const string MissingJoints = "joints without data";
    public const string NotScored = "tool, not scored";
    public const string CountsRow = "frames, samples, dropped";

    public static string Clock(string state, string error, string bound, string skew, string roundTrip) =>
        $"{state}, ± {error} (proven ± {bound}), {skew}, round trip {roundTrip}";

    public static string MedianP95(string median, string p95) => $"{median} median, {p95} P95";
    public static string RmsP95(string rms, string p95) => $"{rms} RMS, {p95} P95";
    public static string Joint(string joint) => $"joint {joint}";
    public static string Object(string frame) => $"object {frame}";
    public static string NotFollowed(string link) => $"not followed: {link} is on another robot or unknown";
    public static string Signal(string signal) => $"signal {signal}";
    public static string Duration(string time) => $" for {time}";
    public static string Outage(string from, string to) => $"outage from {from} to {to}";
    public const string MoreOutages = "more outages";
    public static string NotListed(int outages) => $"{outages}, none longer than the finished ones in the list";
    public static string Stretch(int number) => $"stretch {number}: ";
    public static string Uncompensated(string prefix) => $"{prefix}tool, uncompensated";
    public static string Compensated(string prefix) => $"{prefix}tool, compensated";

    /// <param name="robot">Name of the robot; null if it is not known.</param>
    public static string Title(string robot) => $"{robot ?? "unknown robot"}: results of a headset at this gateway";

    public static string Pose(string state, string after, string share) => $"{state}; current after {after}, then for {share} of the frames";

    public const string OutageDuration = "longest time not current";

    public static string NotCurrent(string time) => $"frames that were not current: {time}";
    public static string CurrentShare(string share, string from, string to) => $"current for {share} of the frames from {from} to {to}";
    public static string Reduction(string prefix) => $"{prefix}reduction, measured by the headset";
}
