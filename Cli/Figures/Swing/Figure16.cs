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
        return new Figure("16", "Swing of the first axis: true, uncompensated, compensated")
        {
            Claim = "The compensated signal follows the true one, while the uncompensated one lags behind; only the curved phases of the profile are hard to predict.",
            Criteria = Criteria(paper.ErrorRatio, paper.SteadyRmsMm, paper.CurvedRmsMm),
            Beyond = runs.Standard.Count < 2 ? null
                : $"the error of adaptive is {Mm(runs.Standard[1].CurvedRmsMm)} where the velocity changes within a section and {Mm(runs.Standard[1].SteadyRmsMm)} where it does not, "
                + $"that of the quadratic {Mm(paper.CurvedRmsMm)} and {Mm(paper.SteadyRmsMm)}.",
            Conditions = ConditionsOf(swing),
            Table = table,
            Plots = [.. PlotsOf(table, runs).Select(plot => plot with { Marks = [.. moments.Select(m => new PlotMark(m.Name, Ms(paper.Shown[m.Index].Time)))] })],
            Summary = Reductions(runs, _ => true, "Tool error over the whole swing, all runs"),
        };
    }

    public static string ConditionsOf(YoubotSwing swing) =>
        "youBot, first axis forward and back by a quarter turn, arm out: the tool moves on a circle of "
        + $"{Text(1000 * swing.Radius)} mm radius at up to {Text(swing.FullSpeed)} mm/s. "
        + "Stroke and limits are ours, because the paper states none. Four shorter moves precede it, and no move repeats. "
        + "The whole chain: samples every 50 ms, stamped in the control system and sent 55 to 105 ms later over a simulated wifi; the clock by RANSAC "
        + "(100 exchanges, 20 hypotheses, moving average of 20); L_visu, in truth 40 ms, from pictures of the simulated display. L is 100 to 150 ms. "
        + "The plots show the forward move of the first run; the numbers include all runs.";

    /// <param name="errorRatio">RMS error of the compensated signal divided by that of the uncompensated one, over all frames.</param>
    /// <param name="steadyMm">RMS error of the compensated signal at constant velocity.</param>
    /// <param name="curvedMm">RMS error of the compensated signal where the velocity changes.</param>
    public static IReadOnlyList<Criterion> Criteria(double errorRatio, double steadyMm, double curvedMm) =>
    [
        new("The RMS error of the compensated signal is less than half of that of the uncompensated one, including the overshoot after each stop.",
            errorRatio < 0.5, Percent(errorRatio)),
        new("Its error is at least 1.5 times as large where the velocity changes within the 250 ms that a section spans as where it does not (RMS).", curvedMm >= 1.5 * steadyMm,
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

        yield return new FigurePlot("Distance on the circle", table.Columns[0], new FigureColumn("distance on the circle", "mm"),
            [truth, hold with { Stepped = true }, .. Compensated(trace => trace)]);
        yield return new FigurePlot("Error", table.Columns[0], new FigureColumn("error", "mm"), [Error(hold), .. Compensated(Error)]);
    }
}
