namespace Nowpose.Cli.Messages;

/// <summary>Titles, labels and sentences of the page of the command <c>calibrate nudge</c>.</summary>
static class NudgePageTexts
{
    public static string Result(double visuMs, double spreadMs, double offsetMm) =>
        FormattableString.Invariant($"L_visu is {visuMs:0.0} ms ± {spreadMs:0.0} ms; the base is displaced by {offsetMm:0.0} mm along the ")
        + "motion.";

    public const string UsedVisu = "L_visu used by the headset";
    public const string BaseOffset = "Displacement of the base along the motion";
    public const string OffsetOverVelocity = "Offset as a function of the velocity";

    public const string OffsetOverVelocityNote =
        "The slope of the line is the error of the L_visu that the headset used; the line's value at zero velocity is the position error of "
        + "the base.";
}
