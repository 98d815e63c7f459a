using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Studies;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>Fig. 18: operating points of the swing in the diagram of Fig. 4, without and with compensation.</summary>
static class Figure18
{
    /// <summary>Duration that the paper shows, s.</summary>
    const double Length = 1.5;

    /// <summary>Minimum speed as a share of the maximum. At lower speeds, the latency e/v is the quotient of two small numbers.</summary>
    const double SlowestShare = 0.05;

    static readonly double[] IsoErrorsMm = [5, 10, 25, 50, 100];

    public static Figure Of(SwingSet runs)
    {
        var table = TableOf(runs);
        var (held, predicted) = (runs.Standard[0].HoldRmsMm(IsWithin), runs.Standard[0].RmsMm(IsWithin));
        return new Figure("18", Figure18Texts.Title)
        {
            Claim = Figure18Texts.Claim,
            Criteria = Criteria(predicted / held, runs.Standard[0].HoldLatencyMs, runs.Standard[0].LatencyMs),
            Beyond = runs.Standard.Count < 2 ? null
                : Figure18Texts.Beyond(Percent(1 - runs.Standard[1].RmsMm(IsWithin) / held), Percent(1 - predicted / held), Text(runs.Standard[1].LatencyMs)),
            Conditions = Figure18Texts.Conditions,
            Table = table,
            Plots = [PlotOf(table, runs)],
            Summary = Figure16.Reductions(runs, IsWithin, Figure18Texts.Summary),
        };
    }

    /// <param name="ratio">RMS error with compensation divided by the RMS error without it.</param>
    /// <param name="heldMs">Median effective latency without compensation, ms.</param>
    /// <param name="predictedMs">Median effective latency with compensation, ms.</param>
    public static IReadOnlyList<Criterion> Criteria(double ratio, double heldMs, double predictedMs) =>
    [
        new(Figure18Texts.ReductionCriterion, ratio <= 0.25, $"{Percent(1 - ratio)} is removed"),
        new(Figure18Texts.LatencyCriterion, 3 * predictedMs < heldMs,
            Figure18Texts.LatencyMeasured(Text(heldMs), Text(predictedMs))),
    ];

    static FigureTable TableOf(SwingSet runs)
    {
        var (swing, shown) = (runs.Swing, runs.Standard[0].Shown);
        var table = new FigureTable([new FigureColumn("time", "ms"), new FigureColumn("speed", "mm/s"),
            new FigureColumn("hold error", "mm"), new FigureColumn("hold latency", "ms"),
            .. runs.Predicted.SelectMany(name => new[] { new FigureColumn($"{name} error", "mm"), new FigureColumn($"{name} latency", "ms") })]);
        for (var i = 0; i < shown.Length; i++)
        {
            var (t, speed) = (shown[i].Time, swing.ToolSpeedAt(shown[i].Time));
            if (!IsShown(swing, t)) continue;
            double?[] Both(double shownAngle, StudyFrame frame)
            {
                var gap = swing.GapMm(shownAngle, frame.Truth);
                return [gap, 1000 * gap / speed];
            }
            table.Add([1000 * t, speed, .. Both(shown[i].Held, shown[i]),
                .. runs.Standard.SelectMany(s => Both(s.Shown[i].Predicted, s.Shown[i]))]);
        }
        return table;
    }

    /// <summary>Gets whether a time since the start of the swing is in the part that the paper shows.</summary>
    public static bool IsWithin(double t) => t >= 0 && t < Length;

    /// <summary>Gets whether the figure shows an operating point for a time since the start of the swing.</summary>
    public static bool IsShown(YoubotSwing swing, double t) => IsWithin(t) && swing.ToolSpeedAt(t) >= SlowestShare * swing.FullSpeed;

    static FigurePlot PlotOf(FigureTable table, SwingSet runs) => new("Operating points", new FigureColumn("latency", "ms"), table.Columns[1],
    [
        table.Trace("uncompensated", Looks.Hold, 3, 1),
        .. runs.Predicted.Select((name, p) => table.Trace(name, Looks.Of(name), 5 + 2 * p, 1)),
    ])
    { IsoMm = IsoErrorsMm };
}
