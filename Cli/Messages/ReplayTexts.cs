namespace Nowpose.Cli.Messages;

/// <summary>Captions of the table of the command <c>replay</c>.</summary>
static class ReplayTexts
{
    public const string Units = "errors in the unit of the file's columns";
    public static string Phases(int count, string min, string max) => $"{count} phases of the frames; compensated RMS of one phase: {min} to {max}";

    public const string DisplayedPosition = "position on the headset, mm";
    public const string DisplayedRotation = "rotation on the headset, °";
    public const string Body = "distance and angle between the displayed and the true pose";
}
