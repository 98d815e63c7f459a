namespace Nowpose.Cli.Demo.Paper;

/// <summary>The measured numbers of one repeat; null where they could not be measured.</summary>
/// <param name="LightErrorMs">P95 of |ε_L|, ms.</param>
/// <param name="ClockProblem">Why numbers other than those of the swings are missing, if any are.</param>
/// <param name="SwingProblem">Why numbers of the swings are missing, if any are.</param>
sealed record PaperMeasures(PaperClock Clock, PaperSwings Swings, double? LightErrorMs, string ClockProblem, string SwingProblem)
{
    public static PaperMeasures Of(PaperRun run) => new(
        PaperClock.Of(run), PaperSwings.Of(run.Swings),
        run.Scored.Count == 0 ? null : Quantile.Of(run.Scored.Select(row => Math.Abs(PaperRun.LightErrorMs(row))), 0.95),
        run.ClockProblem, run.SwingProblem);
}
