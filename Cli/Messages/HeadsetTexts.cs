namespace Nowpose.Cli.Messages;

/// <summary>Labels and values in the table of the command <c>headset</c>.</summary>
static class HeadsetTexts
{
    public static string Title(string robot) => $"{robot}: results of a headset at this gateway";
    public static string Pose(string state, string after, string share) => $"{state}; current after {after}, then for {share} of the frames";

    public const string OutageDuration = "longest time not current";

    public static string NotCurrent(string time) => $"frames that were not current: {time}";
    public static string CurrentShare(string share, string from, string to) => $"current for {share} of the frames from {from} to {to}";
    public static string Reduction(string prefix) => $"{prefix}reduction, measured by the headset";
}
