using Nowpose.Cli.Figures.Model;
using Nowpose.Studies;
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
        return new Figure("18", "Operating points without and with compensation")
        {
            Claim = "Compensation reduces the effective latency without slowing the robot: the errors of the operating points are about 80 % smaller for t < 1500 ms.",
            Criteria = Criteria(predicted / held, runs.Standard[0].HoldLatencyMs, runs.Standard[0].LatencyMs),
            Beyond = runs.Standard.Count < 2 ? null
                : $"adaptive removes {Percent(1 - runs.Standard[1].RmsMm(IsWithin) / held)}, the quadratic {Percent(1 - predicted / held)}; "
                + $"its median effective latency is {Text(runs.Standard[1].LatencyMs)} ms.",
            Conditions = "The first 1500 ms of Fig. 16; the plot shows the first run, the numbers include all. A point with the error e and the velocity v is drawn at the latency e/v; "
                + "points slower than 5 % of the maximum velocity are left out.",
            Table = table,
            Plots = [PlotOf(table, runs)],
            Summary = Figure16.Reductions(runs, IsWithin, "Tool error for t < 1500 ms, all runs"),
        };
    }

    /// <param name="ratio">RMS error with compensation divided by the RMS error without it.</param>
    /// <param name="heldMs">Median effective latency without compensation, ms.</param>
    /// <param name="predictedMs">Median effective latency with compensation, ms.</param>
    public static IReadOnlyList<Criterion> Criteria(double ratio, double heldMs, double predictedMs) =>
    [
        new("75 % or more of the error is removed (RMS; about 80 % in the paper).", ratio <= 0.25, $"{Percent(1 - ratio)} is removed"),
        new("The median effective latency is less than a third of that without compensation.", 3 * predictedMs < heldMs,
            $"{Text(heldMs)} ms without, {Text(predictedMs)} ms with"),
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
