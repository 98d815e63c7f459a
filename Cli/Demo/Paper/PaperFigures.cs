using Nowpose.Cli.Figures;
using Nowpose.Cli.Figures.Clocks;
using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Figures.Swing;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>Creates the paper's Figs 8, 16, 17 and 18 from the first repeat with sufficient data. The claims include all repeats.</summary>
static class PaperFigures
{
    const string FirstSwing = "The plots show the first whole swing after 10 s; the numbers include all whole swings of all repeats.";

    public static IReadOnlyList<Figure> Of(IReadOnlyList<PaperRun> repeats, IReadOnlyList<PaperClaim> claims)
    {
        Criterion[] Criteria(string figure) => [.. claims.Where(claim => claim.Figure == figure).Select(CriterionOf)];
        var synchronised = repeats.FirstOrDefault(repeat => repeat.Steps.Count > 0) ?? repeats[0];
        var clock = SyncFigure.Of(synchronised.Steps, Criteria("8"), ClockConditions(synchronised));
        PaperRun[] swung = [.. repeats.Where(repeat => repeat.Swings != null)];
        if (swung.Length == 0) return [clock];
        var set = new SwingSet([swung[0].Swings], [.. swung.Select(repeat => repeat.Swings)]);
        Figure Shown(Figure figure, string conditions) => figure with { Criteria = Criteria(figure.Number), Conditions = conditions };
        return
        [
            clock,
            Shown(Figure16.Of(set), MotionConditions(swung[0]) + FirstSwing),
            Shown(Figure17.Of(set), "The moments are those marked in Fig. 16: A where the robot reaches its full speed, B half-way, C where half of "
                + "the speed is left. The drawings show the first whole swing; the criteria include all swings."),
            Shown(Figure18.Of(set), "The first 1500 ms of each swing. A point lies at the latency e/v that its error e and its velocity v stand for; "
                + "points slower than 5 % of the maximum velocity are left out. " + FirstSwing),
        ];
    }

    static Criterion CriterionOf(PaperClaim claim) => new(
        claim.Claim, claim.Measured == null ? null : claim.Holds, claim.MeasuredText + (claim.Paper == null ? "" : $"; the paper: {claim.PaperText}"));

    static string ClockConditions(PaperRun run) => $"{run.Run.Settings.Network.Name}, an exchange every 200 ms, {run.Steps.Count} exchanges. "
        + "RANSAC over 100 exchanges with 20 hypotheses, moving average of 20. t and the offsets count from the first exchange, "
        + $"whose Φ* is {FirstOffset(run)}. Θ₂ is the offset at t = 0. RTT includes the time at the server, as in the paper."
        + FitErrors.TextOfExchanges(run.ExchangeErrorsMs);

    static string FirstOffset(PaperRun run) => run.Run.Exchanges.Count == 0 ? "unknown" : FormattableString.Invariant(
        $"{run.Run.Exchanges[0].Offset.HeadsetMinusControl.TotalSeconds:0.000} s: the clocks started at different times");

    static string AddedError(DemoSettings settings) => settings.VisualisationErrorMs == 0 ? ""
        : $", to which --visu-error-ms added {Numbers.Text(settings.VisualisationErrorMs)} ms";

    static string MotionConditions(PaperRun run)
    {
        var (swing, settings) = (run.Swings.Swing, run.Run.Settings);
        return "youBot, first axis forward and back by a quarter turn, arm out: the tool moves on a circle of "
            + $"{Numbers.Text(1000 * swing.Radius)} mm radius at up to {Numbers.Text(swing.FullSpeed)} mm/s. Stroke and limits are ours, "
            + $"the paper gives none. T_s {Numbers.Text(settings.SamplingMs)} ms, "
            + $"acquisition {settings.Acquisition} ms, L_visu {Numbers.Text(settings.VisualisationMs)} ms; the run measured "
            + $"{Numbers.Text(settings.GivenVisualisationMs - settings.VisualisationErrorMs)} ms{AddedError(settings)}. ";
    }
}
