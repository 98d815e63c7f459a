using Nowpose.Cli.Figures.Model;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>Fig. 17: the arm at three instants of Fig. 16.</summary>
static class Figure17
{
    public static Figure Of(SwingSet runs)
    {
        var swing = runs.Swing;
        var moments = SwingMoment.Of(swing, runs.Standard[0].Shown);
        var gaps = moments.Select(m => (Moment: m, Held: HeldGap(runs, m), Predicted: Gaps(runs, m))).ToArray();
        var table = new FigureTable([new FigureColumn("time", "ms"), new FigureColumn("truth", "deg"), new FigureColumn("hold gap", "mm"),
            .. runs.Predicted.Select(name => new FigureColumn($"{name} gap", "mm"))]);
        foreach (var (moment, held, predicted) in gaps)
        {
            var frame = runs.Standard[0].Shown[moment.Index];
            table.Add([1000 * frame.Time, frame.Truth * 180 / Math.PI, held, .. predicted.Select(g => (double?)g)]);
        }
        return new Figure("17", Figure17Texts.Title)
        {
            Claim = Figure17Texts.Claim,
            Criteria = [.. gaps.Zip(runs.Standard[0].GapRatios, (g, ratio) => Criterion(g.Moment.Name, ratio))],
            Beyond = runs.Standard.Count < 2 ? null
                : Figure17Texts.Beyond(string.Join(", ", gaps.Select(g => $"{Mm(g.Predicted[1])} at {g.Moment.Name}"))),
            Conditions = Figure17Texts.Conditions,
            Table = table,
            Drawings = [.. runs.Standard.SelectMany((frames, p) => gaps.Select(g => Drawing(swing, frames, g.Moment, g.Held, g.Predicted[p])))],
        };
    }

    /// <param name="ratio">Gap with compensation divided by the gap without it.</param>
    public static Criterion Criterion(string moment, double ratio) => new(Figure17Texts.Criterion(moment), ratio < 0.5, $"{Percent(ratio)} of it");

    static double HeldGap(SwingSet runs, SwingMoment moment)
    {
        var frame = runs.Standard[0].Shown[moment.Index];
        return runs.Swing.GapMm(frame.Held, frame.Truth);
    }

    static double[] Gaps(SwingSet runs, SwingMoment moment) =>
        [.. runs.Standard.Select(s => runs.Swing.GapMm(s.Shown[moment.Index].Predicted, s.Shown[moment.Index].Truth))];

    static FigureDrawing Drawing(YoubotSwing swing, SwingFrames frames, SwingMoment moment, double heldMm, double predictedMm)
    {
        var frame = frames.Shown[moment.Index];
        return new FigureDrawing($"{moment.Name}, {moment.Description}: {frames.Predictor}",
            Figure17Texts.Drawing(Mm(heldMm), Mm(predictedMm), frames.Predictor),
            new ArmDrawing(swing).Draw(frame, Looks.Of(frames.Predictor), heldMm, predictedMm));
    }
}
