using Nowpose.Cli.Figures.Model;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Fig. 8: convergence of the clock parameters over the sync exchanges.</summary>
static class Figure08
{
    const double PaperBoundUs = 1000;
    const double ShownUs = 600;
    const double ShownPpm = 150;

    public static Figure Of(ClockRuns runs)
    {
        var errors = ClockMethods.All.Select((method, m) => (Name: method, Errors: runs.Errors(m))).ToArray();
        var table = TableOfFirstRun(runs);
        return new Figure("8", "Clock synchronisation")
        {
            Claim = SyncFigure.Claim,
            Criteria = Criteria(FitErrors.ShareBelow(runs.FitErrorsMs), errors[0].Errors, RoundTrips.Of(runs.Logs)),
            Beyond = errors.Length < 2 ? null
                : Figure08Texts.Beyond(Text(errors[1].Errors.P95Us), Percent(errors[1].Errors.P95Us / errors[0].Errors.P95Us), Text(errors[0].Errors.P95Us)),
            Conditions = Figure08Texts.Conditions(runs.Logs.Count, Text(runs.Seconds), FitErrors.TextOfExchanges(runs.ExchangeErrorsMs)),
            Table = table,
            Plots = [.. PlotsOf(table)],
            Summary = new FigureSummary(Figure08Texts.OffsetSummary(Text(ClockErrors.SettledAfter)),
                ["Estimator", "Median (µs)", "P95 (µs)", "Maximum (µs)", Figure08Texts.SkewColumn],
                [.. errors.Select(e => (IReadOnlyList<string>)
                    [e.Name, Text(e.Errors.P50Us), Text(e.Errors.P95Us), Text(e.Errors.MaximumUs), Text(e.Errors.SkewPpmLate)])]),
        };
    }

    /// <param name="fitShare">Share of the exchanges with |ε_i| below 1 ms.</param>
    /// <param name="errors">Errors of the paper's estimator.</param>
    public static IReadOnlyList<Criterion> Criteria(double fitShare, ClockErrors errors, RoundTrips trips) =>
    [
        new(FitErrors.Claim, fitShare >= FitErrors.MinShare, Percent(fitShare)),
        new(Figure08Texts.OffsetCriterion, errors.MaximumUs < PaperBoundUs, $"at most {Text(errors.MaximumUs)} µs"),
        new(Figure08Texts.SkewCriterion,
            2 * errors.SkewPpmLate < errors.SkewPpmEarly, $"{Text(errors.SkewPpmEarly)} ppm, then {Text(errors.SkewPpmLate)} ppm"),
        new(Figure08Texts.RoundTripCriterion,
            2 * trips.ShortUs < trips.LongUs, $"{Text(trips.ShortUs / 1000)} ms against {Text(trips.LongUs / 1000)} ms"),
    ];

    // Columns: the paper's values after each exchange, the true skew, then the offset error and the skew of each estimator.
    static FigureTable TableOfFirstRun(ClockRuns runs)
    {
        var table = new FigureTable([.. SyncFigure.Columns, new FigureColumn("true skew", "ppm"),
            .. ClockMethods.All.SelectMany(m => new[] { new FigureColumn($"{m} offset error", "µs"), new FigureColumn($"{m} skew", "ppm") })]);
        var log = runs.Logs[0];
        var steps = SyncSteps.Of(log.All, ClockMethods.All[0]);
        foreach (var step in steps)
        {
            var s = (step.At - HeadsetTime.FromSeconds(0)).TotalSeconds;
            var i = Math.Min((int)Math.Ceiling(s * ClockRun.InstantsPerSecond), runs.First(0).Count - 1);
            table.Add([.. SyncFigure.ValuesOf(step), log.SkewPpmAt(s),
                .. ClockMethods.All.SelectMany((_, m) => new[] { runs.First(m)[i].OffsetErrorUs, runs.First(m)[i].SkewPpm })]);
        }
        return table;
    }

    static IEnumerable<FigurePlot> PlotsOf(FigureTable table)
    {
        PlotTrace Trace(string label, string look, int column) => table.Trace(label, look, 0, column);
        var truth = SyncFigure.Columns.Count;
        IEnumerable<PlotTrace> OfMethods(int first) => ClockMethods.All.Select((m, i) => Trace(m, Looks.Of(m), truth + first + 2 * i));
        yield return new FigurePlot(Figure08Texts.OffsetPlot, table.Columns[0], new FigureColumn("offset error", "µs"), [.. OfMethods(1)])
        { YRange = (-ShownUs, ShownUs) };
        yield return new FigurePlot(Figure08Texts.SkewPlot, table.Columns[0], new FigureColumn("skew", "ppm"), [Trace("truth", Looks.Truth, truth), .. OfMethods(2)])
        { YRange = (-ShownPpm, ShownPpm) };
        foreach (var plot in SyncFigure.PlotsOf(table)) yield return plot;
    }
}
