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
        return new Figure("17", "The arm at three moments")
        {
            Claim = "The compensation is clearly visible in the headset: with it, the gripper is at the robot; without it, the gripper is beside the robot.",
            Criteria = [.. gaps.Zip(runs.Standard[0].GapRatios, (g, ratio) => Criterion(g.Moment.Name, ratio))],
            Beyond = runs.Standard.Count < 2 ? null
                : "With adaptive the gaps are " + string.Join(", ", gaps.Select(g => $"{Mm(g.Predicted[1])} at {g.Moment.Name}")) + ".",
            Conditions = "The moments are those marked in Fig. 16: A where the robot reaches its full speed, B half-way, C where the speed has fallen to half. "
                + "Gaps are distances of the tool centre points; drawings and table show the first run.",
            Table = table,
            Drawings = [.. runs.Standard.SelectMany((frames, p) => gaps.Select(g => Drawing(swing, frames, g.Moment, g.Held, g.Predicted[p])))],
        };
    }

    /// <param name="ratio">Gap with compensation divided by the gap without it.</param>
    public static Criterion Criterion(string moment, double ratio) => new(
        $"At {moment} the gap with compensation is less than half of the gap without (RMS over all runs).", ratio < 0.5, $"{Percent(ratio)} of it");

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
        return new FigureDrawing($"{moment.Name}, {moment.Words}: {frames.Predictor}",
            $"The youBot's arm seen from above and ahead. The distance to the real gripper is {Mm(heldMm)} for the uncompensated one "
            + $"and {Mm(predictedMm)} for the one compensated by {frames.Predictor}.",
            new ArmDrawing(swing).Draw(frame, Looks.Of(frames.Predictor), heldMm, predictedMm));
    }
}
