namespace Nowpose.Cli.Messages;

/// <summary>Captions of the table of the command <c>replay</c>.</summary>
static class ReplayTexts
{
    public const string All = "all";
    public const string AllUnits = "all (1 rad = 1 m)";
    public const string Units = "errors in the unit of the file's columns; all: the columns are added as if they had one unit";
    public static string Phases(int count, string min, string max) => $"{count} phases of the frames; compensated RMS of one phase: {min} to {max}";

    public const string DisplayedPosition = "position on the headset, mm";
    public const string DisplayedRotation = "rotation on the headset, °";
    public const string Body = "distance and angle between the displayed and the true pose";
}
