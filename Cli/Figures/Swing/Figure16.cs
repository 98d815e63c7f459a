using Nowpose.Cli.Figures.Model;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>Fig. 16: the end effector on its circular path: true, uncompensated and compensated.</summary>
static class Figure16
{
    const double MsPerS = 1000;

    /// <summary>Time shown after the end of the first move, in which the signals come to rest, s.</summary>
    const double Shown = 0.5;

    public static Figure Of(SwingSet runs)
    {
        var (swing, paper) = (runs.Swing, runs.Standard[0]);
        var table = TableOf(runs);
        var moments = SwingMoment.Of(swing, paper.Shown);
        return new Figure("16", Figure16Texts.Title)
        {
            Claim = Figure16Texts.Claim,
            Criteria = Criteria(paper.ErrorRatio, paper.SteadyRmsMm, paper.CurvedRmsMm),
            Beyond = runs.Standard.Count < 2 ? null
                : Figure16Texts.Beyond(Mm(runs.Standard[1].CurvedRmsMm), Mm(runs.Standard[1].SteadyRmsMm), Mm(paper.CurvedRmsMm), Mm(paper.SteadyRmsMm)),
            Conditions = ConditionsOf(swing),
            Table = table,
            Plots = [.. PlotsOf(table, runs).Select(plot => plot with { Marks = [.. moments.Select(m => new PlotMark(m.Name, Ms(paper.Shown[m.Index].Time)))] })],
            Summary = Reductions(runs, _ => true, Figure16Texts.Summary),
        };
    }

    public static string ConditionsOf(YoubotSwing swing) => Figure16Texts.Conditions(Text(1000 * swing.Radius), Text(swing.FullSpeed));

    /// <param name="errorRatio">RMS error of the compensated signal divided by the RMS error of the uncompensated signal, over all frames.</param>
    /// <param name="steadyMm">RMS error of the compensated signal at constant velocity.</param>
    /// <param name="curvedMm">RMS error of the compensated signal where the velocity changes.</param>
    public static IReadOnlyList<Criterion> Criteria(double errorRatio, double steadyMm, double curvedMm) =>
    [
        new(Figure16Texts.FollowsCriterion,
            errorRatio < 0.5, Percent(errorRatio)),
        new(Figure16Texts.CurvedCriterion, curvedMm >= 1.5 * steadyMm,
            $"{Mm(curvedMm)} against {Mm(steadyMm)}"),
    ];

    /// <summary>Gets a table with the RMS errors of hold and all predictors for each scenario.</summary>
    /// <param name="when">Selects frames by their time.</param>
    public static FigureSummary Reductions(SwingSet runs, Func<double, bool> when, string caption)
    {
        var rows = runs.All.Select(f => (Frames: f, Held: f.HoldRmsMm(when), Predicted: f.RmsMm(when)));
        return new FigureSummary(caption, ["Method and conditions", "Hold RMS (mm)", "RMS (mm)", "Error removed"],
            [.. rows.Select(r => (IReadOnlyList<string>)
                [$"{r.Frames.Predictor}, {r.Frames.Scenario.Name}", Text(r.Held), Text(r.Predicted), Percent(1 - r.Predicted / r.Held)])]);
    }

    static double Ms(double time) => Math.Round(MsPerS * time, 2);

    static FigureTable TableOf(SwingSet runs)
    {
        var (swing, shown) = (runs.Swing, runs.Standard[0].Shown);
        var table = new FigureTable([new FigureColumn("time", "ms"), new FigureColumn("truth", "mm"), new FigureColumn("hold", "mm"),
            .. runs.Predicted.Select(name => new FigureColumn(name, "mm"))]);
        for (var i = 0; i < shown.Length && shown[i].Time < swing.MoveSeconds + Shown; i++)
            table.Add([Ms(shown[i].Time), swing.WayMm(shown[i].Truth), swing.WayMm(shown[i].Held),
                .. runs.Standard.Select(s => (double?)swing.WayMm(s.Shown[i].Predicted))]);
        return table;
    }

    static IEnumerable<FigurePlot> PlotsOf(FigureTable table, SwingSet runs)
    {
        IEnumerable<PlotTrace> Compensated(Func<PlotTrace, PlotTrace> shown) =>
            runs.Predicted.Select((name, p) => shown(table.Trace(name, Looks.Of(name), 0, 3 + p)));
        var (truth, hold) = (table.Trace("ground truth", Looks.Truth, 0, 1), table.Trace("uncompensated", Looks.Hold, 0, 2));
        PlotTrace Error(PlotTrace shown) => shown with { Y = [.. shown.Y.Zip(truth.Y, (y, t) => y - t)] };

        yield return new FigurePlot(Figure16Texts.DistancePlot, table.Columns[0], new FigureColumn(Figure16Texts.DistanceAxis, "mm"),
            [truth, hold with { Stepped = true }, .. Compensated(trace => trace)]);
        yield return new FigurePlot("Error", table.Columns[0], new FigureColumn("error", "mm"), [Error(hold), .. Compensated(Error)]);
    }
}
