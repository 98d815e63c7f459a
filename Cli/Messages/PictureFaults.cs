namespace Nowpose.Cli.Messages;

/// <summary>Reasons why a picture gives no L_visu, with remedies.</summary>
static class PictureFaults
{
    public const string PartlyDark = "partly dark: covered, or only a part was lit during the exposure";
    public const string Overexposed = "overexposed, or with a reflection on it";
    public const string Disturbed = "disturbed by a bright background or a reflection";
    public const string Mirrored = "mirrored: switch off mirroring in the camera's settings";

    public static string ControlCodes(string count) => $"{count} control codes: show one only";
    public static string HeadsetCodes(string count) => $"{count} headset codes: show one only";

    public const string NoControlCode = "no control code found";
    public const string NoHeadsetCode = "no headset code found";
    public const string ControlCodeCutOff = "control code partly outside the picture";
    public const string HeadsetCodeCutOff = "headset code partly outside the picture";
    public const string Ambiguous = "two codes equally likely";
    public const string Moved = "taken while the headset moved";

    public static string FarApart(double maxMs) => FormattableString.Invariant($"codes more than {maxMs} ms apart");

    public static string HeadsetAhead(double minMs) =>
        FormattableString.Invariant($"headset code more than {minMs} ms ahead of the control code: if the control code is displayed late, ")
        + "state the delay with --control-delay-ms";

    public const string Stray = "far from the others, probably misread";

    public static string OtherSize(int width, int height, int mostWidth, int mostHeight) =>
        $"{width}x{height} px, but most pictures have {mostWidth}x{mostHeight} px: evaluate each camera's pictures separately";
}
