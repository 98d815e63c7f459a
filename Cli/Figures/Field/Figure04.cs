using Nowpose.Cli.Figures.Clocks;
using Nowpose.Cli.Figures.Model;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Field;

/// <summary>Fig. 4: the error of an object that moves at constant velocity and is displayed late.</summary>
static class Figure04
{
    const double Tolerance = 0.02;
    const double UsPerS = 1e6;

    static readonly double[] IsoErrorsMm = [5, 10, 25, 50, 100, 200];

    public static Figure Of(ErrorField field, ClockRuns clocks)
    {
        var table = TableOf(field.Points, clocks);
        return new Figure("4", Figure04Texts.Title)
        {
            Claim = Figure04Texts.Claim,
            Criteria = Criteria(field.Points),
            Beyond = Beyond(field.Points, clocks),
            Conditions = Figure04Texts.Conditions,
            Table = table,
            Plots = [Plot(field.Points, clocks)],
        };
    }

    public static IReadOnlyList<Criterion> Criteria(IReadOnlyList<FieldPoint> points)
    {
        var worst = points.Max(p => Math.Abs(p.FreshMm / p.FormulaMm - 1));
        var fastest = points.Where(p => p.SpeedMmPerS == points.Max(q => q.SpeedMmPerS)).Select(p => p.FreshMm).ToArray();
        return
        [
            new(Figure04Texts.HoldCriterion(Percent(Tolerance)), worst <= Tolerance, $"within {Percent(worst)}"),
            new(Figure04Texts.MinCriterion,
                fastest.Min() >= 10, Figure04Texts.MinMeasured(Mm(fastest.Min()), Mm(fastest.Max()))),
        ];
    }

    static string Beyond(IReadOnlyList<FieldPoint> points, ClockRuns clocks)
    {
        var predicted = ErrorField.Predicted.Select((name, p) => $"{name} {Mm(points.Max(point => point.PredictedMm[p]))}");
        var left = ClockMethods.All.Select((m, i) => $"{m} {Mm(1000 * clocks.Errors(i).P95Us / UsPerS)}");
        return Figure04Texts.Beyond(string.Join(", ", predicted), string.Join(", ", left));
    }

    static FigureTable TableOf(IReadOnlyList<FieldPoint> points, ClockRuns clocks)
    {
        var table = new FigureTable([new FigureColumn("speed", "mm/s"), new FigureColumn("latency", "ms"), new FigureColumn("formula", "mm"),
            new FigureColumn("hold fresh", "mm"), new FigureColumn("hold", "mm"), .. ErrorField.Predicted.Select(p => new FigureColumn(p, "mm")),
            .. ClockMethods.All.Select(m => new FigureColumn($"{m} clock", "mm"))]);
        foreach (var p in points)
            table.Add([p.SpeedMmPerS, p.LatencyMs, p.FormulaMm, p.FreshMm, p.SampledMm, .. p.PredictedMm.Select(e => (double?)e),
                .. ClockMethods.All.Select((_, m) => (double?)(p.SpeedMmPerS * clocks.Errors(m).P95Us / UsPerS))]);
        return table;
    }

    // Draws each point at the latency e/v that corresponds to its error e.
    static FigurePlot Plot(IReadOnlyList<FieldPoint> points, ClockRuns clocks)
    {
        PlotTrace At(string label, string look, Func<FieldPoint, double> errorMm) =>
            new(label, look, [.. points.Select(p => 1000 * errorMm(p) / p.SpeedMmPerS)], [.. points.Select(p => (double?)p.SpeedMmPerS)]);
        var speeds = points.Select(p => p.SpeedMmPerS).Distinct().ToArray();
        return new FigurePlot("Operating points", new FigureColumn("latency", "ms"), new FigureColumn("speed", "mm/s"),
        [
            At(Figure04Texts.HoldAt50Ms, Looks.Hold, p => p.SampledMm),
            At(Figure04Texts.HoldEveryFrame, Looks.Linear, p => p.FreshMm),
            .. ClockMethods.All.Select((m, i) => new PlotTrace($"predicted, {m} clock", Looks.Of(m),
                [.. speeds.Select(_ => clocks.Errors(i).P95Us / 1000)], [.. speeds.Select(v => (double?)v)])),
        ])
        { IsoMm = IsoErrorsMm };
    }
}
