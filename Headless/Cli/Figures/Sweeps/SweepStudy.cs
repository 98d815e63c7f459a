using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures.Sweeps;

/// <summary>One sweep, and the figures of the paper that show it.</summary>
sealed class SweepStudy(PredictionSweep sweep, params SweepClaims[] claims) : IFigureStudy
{
    public static IEnumerable<SweepStudy> All(FigureSettings settings) =>
    [
        new(new PredictionSweep(SweepAxis.SamplingInterval, settings), Figure13.A, Figure14.A),
        new(new PredictionSweep(SweepAxis.Latency, settings), Figure13.B, Figure14.B),
        new(new PredictionSweep(SweepAxis.LatencyError, settings), Figure13.C, Figure14.C),
        new(new PredictionSweep(SweepAxis.StampError, settings), Figure13.D, Figure14.D),
    ];

    public IReadOnlyList<Action> Work => sweep.Work;

    public IEnumerable<Figure> Figures()
    {
        var data = sweep.Data();
        return claims.Select(each => FigureOf(each, data));
    }

    Figure FigureOf(SweepClaims claims, SweepData data)
    {
        string[] shown = [.. claims.Compared, .. FigureSettings.OurPredictors.Where(data.Has)];
        return new Figure(claims.Number, claims.Title)
        {
            Claim = claims.Claim,
            Criteria = claims.Criteria(data),
            Beyond = Beyond(data),
            Conditions = $"Varied: {sweep.Axis.Column.Label}. Everything else as stated for all figures.",
            Table = TableOf(shown, data),
            Plots = [new FigurePlot("RMS error", sweep.Axis.Column, new FigureColumn("RMS error", "mm"),
                [.. shown.Select(name => new PlotTrace(name, Looks.Of(name), data.Values, [.. data.RmsMm(name)]) { Marked = true })]) { FromZero = true }],
        };
    }

    FigureTable TableOf(string[] shown, SweepData data)
    {
        string[] all = ["hold", .. shown];
        var table = new FigureTable([
            sweep.Axis.Column,
            .. all.Select(name => new FigureColumn($"{name} RMS", "mm")),
            .. shown.Select(name => new FigureColumn($"{name} ratio"))]);
        for (var i = 0; i < data.Values.Count; i++)
        {
            var row = i;
            table.Add([data.Values[row], .. all.Select(name => (double?)data.RmsMm(name)[row]), .. shown.Select(name => (double?)data.Ratio(name, row))]);
        }
        return table;
    }

    static string Beyond(SweepData data) => data.Has("adaptive") ? "adaptive leaves " + Share(data, "quadratic") + " of the quadratic's error. " + Note : null;

    const string Note = "The swing comes back every 2.4 s, which adaptive may recognise and the polynomials cannot.";

    static string Share(SweepData data, string of)
    {
        var shares = Enumerable.Range(0, data.Values.Count).Select(i => data.RmsMm("adaptive")[i] / data.RmsMm(of)[i]).ToArray();
        return $"{Numbers.Percent(shares.Min())} to {Numbers.Percent(shares.Max())}";
    }
}
