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
        return new Figure("4", "Error over velocity and latency")
        {
            Claim = "At constant velocity v, a latency L causes the error e = v·L. At the usual speeds up to 1000 mm/s and latencies of "
                + "30 to 250 ms, the errors are significant.",
            Criteria = Criteria(field.Points),
            Beyond = Beyond(field.Points, clocks),
            Conditions = "Constant velocities. With a sample every 0.5 ms the latency is L alone; with T_s of 50 ms a sample is also T_s/2 old on "
                + "average, so its points are farther right. With prediction, the remaining error is v times the clock error (P95 of Fig. 8).",
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
            new($"The error of hold is v·L within {Percent(Tolerance)}, at each velocity and latency.", worst <= Tolerance, $"within {Percent(worst)}"),
            new("At 1000 mm/s and 30 ms, the error of hold is 10 mm or more.",
                fastest.Min() >= 10, $"{Mm(fastest.Min())}, up to {Mm(fastest.Max())} at 250 ms"),
        ];
    }

    static string Beyond(IReadOnlyList<FieldPoint> points, ClockRuns clocks)
    {
        var predicted = ErrorField.Predicted.Select((name, p) => $"{name} {Mm(points.Max(point => point.PredictedMm[p]))}");
        var left = ClockMethod.All.Select((m, i) => $"{m.Name} {Mm(1000 * clocks.Errors(i).P95Us / UsPerS)}");
        return $"With exact clocks, the largest errors that remain at constant velocity are: {string.Join(", ", predicted)}. "
            + $"At 1000 mm/s, the errors from the clock estimators are at most, 95 % of the time: {string.Join(", ", left)}.";
    }

    static FigureTable TableOf(IReadOnlyList<FieldPoint> points, ClockRuns clocks)
    {
        var table = new FigureTable([new FigureColumn("speed", "mm/s"), new FigureColumn("latency", "ms"), new FigureColumn("formula", "mm"),
            new FigureColumn("hold fresh", "mm"), new FigureColumn("hold", "mm"), .. ErrorField.Predicted.Select(p => new FigureColumn(p, "mm")),
            .. ClockMethod.All.Select(m => new FigureColumn($"{m.Name} clock", "mm"))]);
        foreach (var p in points)
            table.Add([p.SpeedMmPerS, p.LatencyMs, p.FormulaMm, p.FreshMm, p.SampledMm, .. p.PredictedMm.Select(e => (double?)e),
                .. ClockMethod.All.Select((_, m) => (double?)(p.SpeedMmPerS * clocks.Errors(m).P95Us / UsPerS))]);
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
            At("hold, a sample every 50 ms", Looks.Hold, p => p.SampledMm),
            At("hold, a sample in every frame", Looks.Linear, p => p.FreshMm),
            .. ClockMethod.All.Select((m, i) => new PlotTrace($"predicted, {m.Name} clock", Looks.Of(m.Name),
                [.. speeds.Select(_ => clocks.Errors(i).P95Us / 1000)], [.. speeds.Select(v => (double?)v)])),
        ])
        { IsoMm = IsoErrorsMm };
    }
}
