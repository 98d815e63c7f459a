using Nowpose.Cli.Demo;

namespace Nowpose.Cli.Messages;

/// <summary>Messages about failures and errors of the command <c>demo</c>, with remedies.</summary>
static class DemoMessages
{
    const string Report = "this is a bug in Nowpose; report it with the command line and the version";

    public static string ToolNotFinite(int frame) => $"frame {frame}: the position of the displayed tool is not finite; {Report}";
    public static string GhostNotFinite(int frame) => $"frame {frame}: the position of the ghost's tool is not finite; {Report}";
    public static string JointNotFinite(int frame, int joint) => $"frame {frame}: the position of moving joint {joint} is not finite; {Report}";
    public static string BodyNotFinite(int frame, string name) => $"frame {frame}: the pose of the displayed object {name} is not finite; {Report}";
    public static string GhostBodyNotFinite(int frame, string name) => $"frame {frame}: the pose of the ghost of object {name} is not finite; {Report}";
    public static string ClockNotFinite(int frame) => $"frame {frame}: the clock offset is not finite; {Report}";
    public static string Links(Network.LinkStatus joints, Network.LinkStatus clock) => $"joint positions {joints}; clock sync {clock}";
    public static string NoSample(long dropped, string links) => $"no sample was used, and {dropped} were dropped: check that no other program uses the ports, and run longer (--seconds); {links}";

    public static string NoClock(string state, double seconds, string links) =>
        FormattableString.Invariant($"the clock was still {state} after {seconds} s: run longer (--seconds); {links}");

    public static string SceneError(string error) => $"the scene logged an error: {error}; {Report}";

    public static string NotWithPaper(string options) =>
        $"{options}: cannot be combined with --paper, which sets the paper's robot, motion, predictor, clock estimator, sampling interval "
        + "and load, and measures the profile itself";

    public const string RepeatsAlone = "--repeats: needs --paper or --virtual; add one of them, or remove --repeats";

    public const string NotWithVirtual = "cannot be combined with --virtual, which does not play the scene; remove one of the two options";

    public static string SamplingWithVirtual(double ms, double min) =>
        FormattableString.Invariant($"--sampling-ms: {ms} ms is out of range; allowed with --virtual: {min} to 1000 ms");

    public static string PaperSeconds(double seconds, double min) =>
        FormattableString.Invariant($"--seconds: {seconds} s is out of range; allowed with --paper: {min} to 3600 s");

    public static string Interrupted(double seconds, double allSeconds) =>
        FormattableString.Invariant($"the run was interrupted after {seconds:0.0} of {allSeconds} s, so the results are those of this part; ")
        + "run it again";

    public static string RepeatsInterrupted(int complete, int repeats) => complete == 0
        ? "the run was interrupted in its first repeat, so no claim was judged, and the other results are those of a part of it; run it again"
        : $"the run was interrupted, so the claims are judged by {complete} of {repeats} repeats; run it again";

    public static string FiguresInterrupted(int complete, int repeats) =>
        $"the run was interrupted, so the figures are those of {complete} of {repeats} repeats; run it again";

    public static string OfRepeat(int repeat, string note) => FormattableString.Invariant($"repeat {repeat}: {note}");

    public static string LinesLost(long lines) =>
        FormattableString.Invariant($"session.jsonl: {lines} lines are missing, because the disk was too slow; set --out to a faster disk");

    public static string LateFrames(LateFrames late) =>
        FormattableString.Invariant($"{late.Count} of {late.All} frames began late, by up to {late.MaxMs:0} ms: this machine was busy, which ")
        + "increased delays and errors; run it again without other programs";

    public static string OtherRecording(string path) =>
        $"--out: {path} is a recording that is not from an earlier demo and would be replaced; use another folder, or move the file";

    public static string FolderInUse(string folder) => $"--out: another nowpose writes to {folder}; use another folder, or wait until it has ended";

    public static string AssumedVisu(double ms) =>
        FormattableString.Invariant($"--visu-ms plus --visu-error-ms: {ms} ms is out of range; allowed: 0 to 500 ms");

    public static string VisuWithLoad(double ms, string option, double min) =>
        FormattableString.Invariant($"--visu-ms: {ms} ms is out of range; with {option}, {min} to 400 ms are allowed, because the display ")
        + "runs at 60 Hz";

    public static string NoCalibration(int read, int pictures) =>
        $"the calibration found no display latency: {read} of {pictures} pictures could be read; run longer (--seconds)";
}
