namespace Nowpose.Cli.Demo.Paper;

/// <summary>The measured numbers of one repeat. Null where the run was too short.</summary>
/// <param name="LightErrorMs">P95 of |ε_L|, ms.</param>
/// <param name="Problem">Why numbers are missing; null if none is.</param>
sealed record PaperMeasures(PaperClock Clock, PaperSwings Swings, double? LightErrorMs, string Problem = null)
{
    public static PaperMeasures Of(PaperRun run) => new(
        PaperClock.Of(run), PaperSwings.Of(run.Swings),
        run.Scored.Count == 0 ? null : Quantile.Of(run.Scored.Select(row => Math.Abs(PaperRun.LightErrorMs(row))), 0.95),
        run.Problem);
}
