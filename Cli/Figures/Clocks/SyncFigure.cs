using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Fig. 8 of recorded exchanges, in the paper's quantities.</summary>
static class SyncFigure
{
    public static Figure Of(IReadOnlyList<SyncStep> steps, IReadOnlyList<Criterion> criteria, string conditions)
    {
        var table = new FigureTable(
            new FigureColumn("time", "s"), new FigureColumn("offset", "ms"), new FigureColumn("fitted offset", "ms"), new FigureColumn("skew", "ppm"),
            new FigureColumn("theta2", "ms"), new FigureColumn("fit error", "ms"), new FigureColumn("round trip", "ms"));
        foreach (var step in steps)
            table.Add(step.Seconds, step.OffsetMs, step.FitMs, step.SkewPpm, step.InterceptMs, step.FitErrorMs, step.RoundTripMs);
        return new Figure("8", "Clock synchronisation")
        {
            Claim = "As exchanges come in, offset and skew converge and the fitting error becomes less than 1 ms; "
                + "the round-trip time shows how accurate an exchange was.",
            Criteria = criteria,
            Conditions = conditions,
            Table = table,
            Plots = [.. PlotsOf(table)],
        };
    }

    static IEnumerable<FigurePlot> PlotsOf(FigureTable table)
    {
        FigurePlot Plot(string title, FigureColumn y, params PlotTrace[] traces) => new(title, table.Columns[0], y, traces);
        PlotTrace Trace(string label, int column, string look = Looks.Quadratic) => table.Trace(label, look, 0, column);
        yield return Plot("Offset Φ*, relative to the first", new FigureColumn("offset", "ms"),
            Trace("Φ* of each exchange", 1, Looks.Hold) with { Scattered = true }, Trace("(γ₂−1)·t + Θ₂", 2));
        yield return Plot("Skew γ₂−1", new FigureColumn("skew", "ppm"), Trace("γ₂−1", 3));
        yield return Plot("Θ₂, the offset at the first exchange", new FigureColumn("Θ₂", "ms"), Trace("Θ₂", 4));
        yield return Plot("Fitting error ε", new FigureColumn("ε", "ms"), Trace("ε of each exchange", 5, Looks.Samples) with { Scattered = true });
        yield return Plot("Round-trip time", new FigureColumn("RTT", "ms"), Trace("RTT", 6, Looks.Samples)) with { FromZero = true };
    }
}
