namespace Nowpose.Cli.Messages;

/// <summary>Error messages and warnings of the command <c>recommend</c>, with remedies.</summary>
static class RecommendMessages
{
    public static string TooShort(string path) => $"{path}: is too short: no frame could be evaluated in one of its halves; record a longer motion";

    public const string GridSets = "--grid also sets this value; remove one of the two options";

    public static string RigidBody(string path) =>
        $"{path}: is the recording of a rigid body; recommend supports joints only. Use `replay --predictor NAME` instead";

    public static string NoMotion(double range) =>
        FormattableString.Invariant($"no joint moves by more than {range:G2} rad or m: a recommendation needs a recording of motion");

    public static string Short(double seconds, double minSeconds) =>
        FormattableString.Invariant($"the recording is only {seconds:0.0} s long, so the result may be due to chance; record {minSeconds} s or more");

    public static string LateStamps(double p5Ms, double p95Ms) =>
        FormattableString.Invariant($"the intervals between time stamps are {p5Ms:0.0} to {p95Ms:0.0} ms long (P5 to P95): late time stamps reduce ")
        + "the accuracy; take the time stamps from the controller";

    public static string Interrupted(int done, int all) =>
        $"the evaluation was interrupted after {done} of {all} runs, so another predictor or blend can be better; run it again";

    public static string Repeats(double percent) =>
        FormattableString.Invariant($"{percent:0.0} % of a moving joint's samples repeat the previous one: the robot's sampling interval ")
        + "or resolution is coarser than that of the recording; record at the robot's own rate";
}
