namespace Nowpose.Cli.Messages;

/// <summary>Titles, labels and sentences of the page of the command <c>calibrate range</c>.</summary>
static class RangePageTexts
{
    public const string OverPictures = "Render time and L_visu from picture to picture";

    public const string OverPicturesNote =
        "While frames are ready in time, L_visu does not depend on the render time; beyond the limit it increases and scatters.";

    public const string OverLoad = "Render time and L_visu as a function of the load";

    public const string OverLoadNote =
        "Median and middle 68 %. L_visu is constant up to a number of vertices that depends on the scene. The headset monitors the render "
        + "time, which increases with the load.";

    public const string OverRenderTime = "L_visu as a function of the render time";
    public const string NoLimitNote = "The limit was not reached: L_visu is constant at least up to the longest measured render time.";
    public const string LimitNote = "Left of the limit is the constant-latency range.";
    public const string OutsidePlateau = "Outside the plateau (misread, or delayed by a slow frame)";

    public static string Result(double visuMs, double spreadMs, double limitMs) =>
        FormattableString.Invariant($"L_visu is {visuMs:0.0} ms ± {spreadMs:0.0} ms while the render time is below {limitMs:0.00} ms.");

    public static string ResultWithoutLimit(double visuMs, double spreadMs, double validToMs) =>
        FormattableString.Invariant($"L_visu is {visuMs:0.0} ms ± {spreadMs:0.0} ms; limit not reached: constant at least up to a render ")
        + FormattableString.Invariant($"time of {validToMs:0.00} ms.");
}
