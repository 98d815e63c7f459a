namespace Nowpose.Cli.Messages;

/// <summary>Titles, labels and sentences of the calibration page and its table.</summary>
static class CalibrationPageTexts
{
    public const string HeadMotion = "Latency for head motion";
    public const string ControlCodeSpeed = "Speed of the control code (RMS)";

    public static string HeadMotionResult(double latencyMs, double uncertaintyMs, double visuMs) =>
        FormattableString.Invariant($"The latency for head motion is {latencyMs:0.0} ms ± {uncertaintyMs:0.0} ms (95 %); L_visu is ")
        + FormattableString.Invariant($"{visuMs:0.0} ms.");

    public const string OffsetOverSpeed = "Offset of the codes as a function of the speed";

    public const string OffsetOverSpeedNote =
        "The slope is the latency for head motion: with a latency L, the picture lags by the distance that the head moves during L. Without "
        + "any correction, the latency is L_visu minus the prediction time of the head's pose; with a full correction, the line is horizontal.";

    public const string ControlCodeSpeedAxis = "speed of the control code";
    public const string CodeOffsetAxis = "headset code minus control code";
    public const string ConstantUpTo = "Known to be constant up to";
    public const string RenderTimeSource = "Render time measured with";
    public const string ValidForAny = "any (not stated)";

    public const string OverPictures = "L_visu from picture to picture";

    public const string OverPicturesNote =
        "A picture is taken at a random moment while a frame is lit. L_visu therefore scatters around its mean, by up to half of the time for "
        + "which a frame is lit. The result is the mean.";
}
