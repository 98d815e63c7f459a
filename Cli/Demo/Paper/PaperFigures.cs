using Nowpose.Cli.Figures;
using Nowpose.Cli.Figures.Clocks;
using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Figures.Swing;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>Creates the paper's Figs 8, 16, 17 and 18 from the first repeat with sufficient data. The claims include all repeats.</summary>
static class PaperFigures
{
    const string FirstSwing = PaperFigureTexts.FirstSwing;

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
            Shown(Figure17.Of(set), PaperFigureTexts.Moments),
            Shown(Figure18.Of(set), PaperFigureTexts.OperatingPoints(FirstSwing)),
        ];
    }

    static Criterion CriterionOf(PaperClaim claim) => new(
        claim.Claim, claim.Measured == null || claim.IsUndecided ? null : claim.Holds,
        claim.MeasuredText + (claim.Paper == null ? "" : $"; the paper: {claim.PaperText}"))
    { IsUndecided = claim.IsUndecided };

    static string ClockConditions(PaperRun run) => PaperFigureTexts.Clock(run.Run.Settings.Network.Name, run.Steps.Count, FirstOffset(run), FitErrors.TextOfExchanges(run.ExchangeErrorsMs));

    static string FirstOffset(PaperRun run) => run.Run.Exchanges.Count == 0 ? "unknown" : PaperFigureTexts.FirstOffset(run.Run.Exchanges[0].Offset.HeadsetMinusControl.TotalSeconds);

    static string AddedError(DemoSettings settings) => settings.VisualisationErrorMs == 0 ? ""
        : PaperFigureTexts.AddedError(Numbers.Text(settings.VisualisationErrorMs));

    static string MotionConditions(PaperRun run)
    {
        var (swing, settings) = (run.Swings.Swing, run.Run.Settings);
        return PaperFigureTexts.Motion(Numbers.Text(1000 * swing.Radius), Numbers.Text(swing.FullSpeed), Numbers.Text(settings.SamplingMs), settings.Acquisition, Numbers.Text(settings.VisualisationMs), Numbers.Text(settings.GivenVisualisationMs - settings.VisualisationErrorMs), AddedError(settings));
    }
}
