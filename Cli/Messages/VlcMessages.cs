namespace Nowpose.Cli.Messages;

/// <summary>Warnings and results of the command <c>calibrate vlc</c>, with remedies.</summary>
static class VlcMessages
{
    public static string OtherSweep(int joined, int pictures) =>
        $"--sweep: the log has the frames of only {joined} of {pictures} pictures; use the log of the sweep that the pictures show";

    public static string NotInSweep(int missing, int pictures) =>
        $"{missing} of {pictures} pictures show a frame that is not in the sweep log; use the log of the sweep in which they were taken";

    public static string OtherSource(int others, int all, string source) =>
        $"{others} of {all} render times of the sweep were measured with a source other than {source} and are not used";

    public static string OrderUnknown(double periodSeconds) =>
        FormattableString.Invariant($"--sweep: the codes repeat after {periodSeconds:0.0} s, but the sweep is longer, and the names of the pictures do not ")
        + "sort in the order in which they were taken: name the files so that they sort in that order, or repeat the measurement with a shorter sweep";

    public static string LatePictures(int late, int pictures) =>
        $"{late} of {pictures} pictures show a frame that was displayed late, and were not used. If they were taken at several loads, add the "
        + "sweep's log with --sweep";

    public static string FewPictures(int pictures) =>
        $"L_visu was computed from only {pictures} pictures and may be wrong by a few ms: take 30 or more";

    public static string NoVisuInSweep(int pictures) =>
        $"L_visu cannot be determined from these {pictures} pictures of the sweep; no profile was written; take more pictures";

    public static string NarrowExposures(double spanMs, double maxErrorMs) =>
        FormattableString.Invariant($"the exposures cover only {spanMs:0.0} ms of the display's refresh interval: the camera is in step with the ")
        + FormattableString.Invariant($"display, and L_visu may be wrong by up to {maxErrorMs:0.0} ms. Film at 25 or 50 pictures a second, or take ")
        + "single pictures, and keep the dark ones";

    public const string OnePicture = "one picture is not enough for a profile, so no profile was written; take 30 or more";

    public static string Scatters(double? deviationMs) =>
        FormattableString.Invariant($"L_visu scatters by {deviationMs:0.0} ms, too much for one constant value. If the pictures were taken at ")
        + "several loads, add the sweep's log with --sweep. No profile was written";

    public static string NoVisu(int pictures) =>
        FormattableString.Invariant($"L_visu cannot be determined; pictures read: {pictures}. Take more pictures.");

    public static string Result(double visuMs, double spreadMs, int pictures) =>
        FormattableString.Invariant($"L_visu is {visuMs:0.0} ms ± {spreadMs:0.0} ms, from {pictures} pictures.");

    public const string NoPicture = "no picture was evaluated; pass pictures that show both codes";

    public static string NothingRead(int pictures, int count, string fault) =>
        $"none of {pictures} pictures could be read; {count} of them: {fault}";
}
