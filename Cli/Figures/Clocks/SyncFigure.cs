using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Fig. 8 for recorded exchanges, with the paper's quantities.</summary>
static class SyncFigure
{
    /// <summary>Minimum number of settled values for a limited axis, and the share of these values that can be outside it at each end.</summary>
    const int MinSettled = 10;
    const double Tail = 0.02;

    public const string Claim = Figure08Texts.Claim;

    /// <summary>Columns of the paper's quantities. The first one is the time.</summary>
    public static readonly IReadOnlyList<FigureColumn> Columns =
    [
        new("time", "s"), new("offset", "ms"), new("fitted offset", "ms"), new("skew", "ppm"), new("theta2", "ms"), new("fit error", "ms"),
        new("round trip", "ms"),
    ];

    /// <summary>Gets the values of a step for <see cref="Columns"/>.</summary>
    public static IEnumerable<double?> ValuesOf(SyncStep step) =>
        [step.Seconds, step.OffsetMs, step.FitMs, step.SkewPpm, step.InterceptMs, step.FitErrorMs, step.RoundTripMs];

    public static Figure Of(IReadOnlyList<SyncStep> steps, IReadOnlyList<Criterion> criteria, string conditions)
    {
        var table = new FigureTable([.. Columns]);
        foreach (var step in steps) table.Add([.. ValuesOf(step)]);
        return new Figure("8", "Clock synchronisation")
        {
            Claim = Claim,
            Criteria = criteria,
            Conditions = conditions,
            Table = table,
            Plots = steps.Count == 0 ? [] : [.. PlotsOf(table)],
        };
    }

    /// <summary>
    /// Limits the vertical axis to the values of the settled clock. Otherwise, a slow exchange or the first estimates of the skew would
    /// compress all other values to a flat line. The title states how many values are outside the axis.
    /// </summary>
    static FigurePlot Settled(FigurePlot plot)
    {
        var end = plot.Traces.Max(trace => trace.X[^1]);
        var from = Math.Min(ClockErrors.SettledAfter, end / 2);
        double[] Values(double since) => [.. plot.Traces.SelectMany(trace => trace.X.Zip(trace.Y))
            .Where(point => point.First >= since && point.Second.HasValue).Select(point => point.Second.Value)];
        var (all, settled) = (Values(0), Values(from));
        if (settled.Length < MinSettled) return plot;
        var (low, high) = (Quantile.Of(settled, Tail), Quantile.Of(settled, 1 - Tail));
        var margin = high - low;
        if (margin == 0) return plot;
        (low, high) = (plot.FromZero ? 0 : low - margin, high + margin);
        var beyond = all.Count(value => value < low || value > high);
        return beyond == 0 ? plot : plot with
        {
            YRange = (low, high),
            Title = Figure08Texts.BeyondAxis(plot.Title, beyond, all.Length),
        };
    }

    /// <param name="table">A table whose first columns are <see cref="Columns"/>.</param>
    public static IEnumerable<FigurePlot> PlotsOf(FigureTable table)
    {
        FigurePlot Plot(string title, FigureColumn y, params PlotTrace[] traces) => new(title, table.Columns[0], y, traces);
        PlotTrace Trace(string label, int column, string look = Looks.Quadratic) => table.Trace(label, look, 0, column);
        yield return Settled(Plot(Figure08Texts.RelativeOffset, new FigureColumn("offset", "ms"),
            Trace("Φ* of each exchange", 1, Looks.Hold) with { Scattered = true }, Trace("(γ₂−1)·t + Θ₂", 2)));
        yield return Settled(Plot("Skew γ₂−1", new FigureColumn("skew", "ppm"), Trace("γ₂−1", 3)));
        yield return Settled(Plot(Figure08Texts.FirstOffset, new FigureColumn("Θ₂", "ms"), Trace("Θ₂", 4)));
        yield return Settled(Plot("Fitting error ε", new FigureColumn("ε", "ms"), Trace("ε of each exchange", 5, Looks.Samples) with { Scattered = true }));
        yield return Settled(Plot("Round-trip time", new FigureColumn("RTT", "ms"), Trace("RTT", 6, Looks.Samples)) with { FromZero = true });
    }
}
