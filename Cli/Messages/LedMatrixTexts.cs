namespace Nowpose.Cli.Messages;

/// <summary>Labels in the picture of the LED matrix.</summary>
static class LedMatrixTexts
{
    public const string Label =
        "Front of the LED matrix: 18 pairs of LEDs inside a lit ring. Pitch, margin, bytes and bits are labelled. The codes of the control system "
        + "and the headset show 12345 ms";

    public const string TopMarks = "two dark marks at the top";
    public const string Pairs = "one LED of each pair is lit: left for 1, right for 0";
    public const string RightMarks = "two more dark marks on the right";
    public const string NoMargin = "no margin; a headset does not draw black";
    public const string Front = "front of the board";
}
