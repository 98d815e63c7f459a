namespace Nowpose.Cli.Messages;

/// <summary>Conditions of the figures of <c>demo --paper</c>.</summary>
static class PaperFigureTexts
{
    public const string FirstSwing = "The plots show the first whole swing after 10 s; the numbers include all whole swings of all repeats.";

    public const string Moments =
        "The moments are those marked in Fig. 16: A when the robot reaches its full speed, B halfway, C when the speed has fallen to half. "
        + "The drawings show the first whole swing; the criteria include all swings.";

    public static string OperatingPoints(string swing) =>
        "The first 1500 ms of each swing. A point with the error e and the velocity v is drawn at the latency e/v; points slower than "
        + $"5 % of the maximum velocity are left out. {swing}";

    public static string Clock(string network, int exchanges, string offset, string exchangeErrors) =>
        $"{network}, an exchange every 200 ms, {exchanges} exchanges. RANSAC over 100 exchanges with 20 hypotheses, moving average of 20. t "
        + $"and the offsets are relative to the first exchange, whose Φ* is {offset}. Θ₂ is the offset at t = 0. RTT includes the time at the "
        + $"server, as in the paper.{exchangeErrors}";

    public static string FirstOffset(double seconds) => FormattableString.Invariant($"{seconds:0.000} s: the clocks started at different times");
    public static string AddedError(string ms) => $", to which --visu-error-ms added {ms} ms";

    public static string Motion(string radiusMm, string speed, string samplingMs, Gateway.Options.MillisecondRange acquisition, string visuMs, string measuredMs, string addedError) =>
        $"youBot, first axis forward and back by a quarter turn, arm extended: the tool moves on a circle of {radiusMm} mm radius at up to "
        + $"{speed} mm/s. We chose the stroke and the limits, because the paper states none. T_s {samplingMs} ms, acquisition {acquisition} ms, L_visu "
        + $"{visuMs} ms; the run measured {measuredMs} ms{addedError}. ";
}
