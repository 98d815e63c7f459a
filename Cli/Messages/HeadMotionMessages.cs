namespace Nowpose.Cli.Messages;

/// <summary>Error messages and warnings of the command <c>calibrate head</c>, with remedies.</summary>
static class HeadMotionMessages
{
    public static string TooFewPictures(int pictures, int min) =>
        $"{pictures} pictures are close enough in time to their neighbours to measure a speed; at least {min} are needed: film for ten "
        + "seconds or more, at 25 pictures per second or more";

    public static string TooSlow(double pxPerS, double min) =>
        FormattableString.Invariant($"the control code moves at {pxPerS:0} px/s in the pictures; at least {min} px/s are needed: turn ")
        + "headset and camera together to the left and right";

    /// <param name="percent">Share of the pictures in which the headset moves in its more frequent direction, %.</param>
    public static string TooFewTurns(int turns, double percent, double maxPercent) =>
        FormattableString.Invariant($"the headset changed direction {turns} times, and moved in one direction in {percent:0} % of the pictures; at ")
        + FormattableString.Invariant($"most {maxPercent:0} % are allowed: turn it at least twice in each direction, equally fast");

    public static string NotWorldLocked(double ratio) =>
        FormattableString.Invariant($"the hologram moves {ratio:0.0} px while the control code moves 1 px; both must stay in the same ")
        + "place in the room: disable Body Follow, and place the headset's code at the distance of the control code";

    public const string NoProfile =
        "no profile was written: add --profile with the profile from the pictures without head motion, to which the latency for head motion is added";

    public const string UnknownReprojection =
        "the reprojection mode is unknown: state it with --reprojection, because the latency is valid for one mode only";

    public static string Uncertain(double uncertaintyMs) =>
        FormattableString.Invariant($"the latency is uncertain by ± {uncertaintyMs:0.0} ms: turn farther or faster, or film longer");

    public static string OtherVisu(double movingMs, double stillMs) =>
        FormattableString.Invariant($"L_visu is {movingMs:0.0} ms in the pictures with head motion and {stillMs:0.0} ms in those without it. ")
        + "The profile keeps the latter. Check that both were taken with the same settings and a low load";
}
