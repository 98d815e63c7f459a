namespace Nowpose.Cli.Messages;

/// <summary>Reasons why L_visu cannot be determined from a picture, with remedies.</summary>
static class PictureFaults
{
    const string Unclear = "; use a plain background behind the hologram, or a shorter exposure";
    const string ShowBoth = "; show both codes in focus, each at least a tenth as high as the picture";

    public const string PartlyDark =
        "partly dark: covered, or only a part was lit during the exposure; remove what covers it, or, if the display scans, use a longer "
        + "exposure (8 ms)";
    public const string Overexposed = "overexposed, or with a reflection on it; shorten the exposure, or move the lamp";
    public const string Disturbed = "disturbed by a bright background or a reflection; use a plain dark background, or move the lamp";
    public const string Mirrored = "mirrored: switch off mirroring in the camera's settings";

    public static string ControlCodes(string count) => $"{count} control codes: show only one";
    public static string HeadsetCodes(string count) => $"{count} headset codes: show only one";

    public const string PartlyCovered = "partly covered; remove what is in front of it";
    public const string NoMargin = "without a dark margin; give it a black margin as wide as the pitch of its LEDs";
    public const string Undecided = "unclear: some of its pairs show neither 0 nor 1" + Unclear;
    public const string WrongParity = "misread: its parity is wrong" + Unclear;
    public const string Inconsistent = "unclear: the brightness of its cells matches no time" + Unclear;
    public const string TooWeak = "unclear: its contrast is too low or too high" + Unclear;
    public const string AmbiguousTime = "ambiguous: more than one time fits" + Unclear;
    public const string NoCode = "no code found" + ShowBoth;
    public const string NoControlCode = "no control code found" + ShowBoth;
    public const string NoHeadsetCode = "no headset code found" + ShowBoth;
    public const string ControlCodeCutOff = "control code partly outside the picture; move the camera";
    public const string HeadsetCodeCutOff = "headset code partly outside the picture; move the camera";
    public const string Ambiguous = "two codes equally likely, because the frame changed during the exposure; take more pictures";

    public static string FarApart(double maxMs) => FormattableString.Invariant($"codes more than {maxMs} ms apart; check that both show the same clock");

    public static string HeadsetAhead(double minMs) =>
        FormattableString.Invariant($"headset code more than {minMs} ms ahead of the control code: if the control code is displayed late, ")
        + "state the delay with --control-delay-ms";

    public const string Stray = "probably misread: L_visu is far from that of the other pictures; take more pictures";

    public static string OtherSize(int width, int height, int mostWidth, int mostHeight) =>
        $"{width}x{height} px, but most pictures have {mostWidth}x{mostHeight} px: evaluate each camera's pictures separately";
}
