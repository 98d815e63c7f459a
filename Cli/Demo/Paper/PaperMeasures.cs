namespace Nowpose.Cli.Demo.Paper;

/// <summary>The measured values of one repeat. A value is null if it could not be measured.</summary>
/// <param name="LightErrorMs">P95 of |ε_L|, the error of the display time, ms.</param>
/// <param name="ClockProblem">Reason why values of the clock or the latency are missing; unused if none is missing.</param>
/// <param name="SwingProblem">Reason why values of the swings are missing; unused if none is missing.</param>
sealed record PaperMeasures(PaperClock Clock, PaperSwings Swings, double? LightErrorMs, string ClockProblem, string SwingProblem)
{
    public static PaperMeasures Of(PaperRun run) => new(
        PaperClock.Of(run), PaperSwings.Of(run.Swings),
        run.Scored.Count == 0 ? null : Quantile.Of(run.Scored.Select(row => Math.Abs(PaperRun.LightErrorMs(row))), 0.95),
        run.ClockProblem, run.SwingProblem);
}
