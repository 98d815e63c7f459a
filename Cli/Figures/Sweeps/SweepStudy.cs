using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Studies;

namespace Nowpose.Cli.Figures.Sweeps;

/// <summary>A sweep of one condition, and the figures of the paper that show it.</summary>
sealed class SweepStudy : IFigureStudy
{
    /// <summary>Seed of the random moves, none of which repeats.</summary>
    const int RandomMovesSeed = 1301;

    public static readonly string[] OfThePaper = ["linear", "quadratic", "cubic", "quadratic-h3", "quadratic-h4"];

    readonly IReadOnlyList<string> _ours;
    readonly MotionLimits _limits;
    readonly SweepAxis _axis;
    readonly SweepClaims[] _claims;
    readonly PredictionSweep _swing;
    readonly PredictionSweep _random;

    public SweepStudy(FigureSettings settings, SweepAxis axis, params SweepClaims[] claims)
    {
        _ours = settings.Ours;
        _limits = settings.Limits;
        _axis = axis;
        _claims = claims;
        _swing = new PredictionSweep(axis, settings, Motions.Swing(settings.Limits.Move(), settings.SwingSeconds), [.. OfThePaper, .. _ours]);
        _random = new PredictionSweep(axis, settings, Motions.FastMoves(RandomMovesSeed, settings.RandomSeconds),
            ["quadratic", .. _ours]);
        Work = [.. _swing.Work, .. _random.Work];
    }

    public static IEnumerable<SweepStudy> All(FigureSettings settings) =>
    [
        new(settings, SweepAxis.SamplingInterval, Figure13.A, Figure14.A),
        new(settings, SweepAxis.Latency, Figure13.B, Figure14.B),
        new(settings, SweepAxis.LatencyError, Figure13.C, Figure14.C),
        new(settings, SweepAxis.StampError, Figure13.D, Figure14.D),
    ];

    public IReadOnlyList<Action> Work { get; }

    public IEnumerable<Figure> Figures()
    {
        var (swing, random) = (_swing.Data(), _random.Data());
        return _claims.Select(claims => FigureOf(claims, swing, random));
    }

    Figure FigureOf(SweepClaims claims, SweepData swing, SweepData random)
    {
        string[] shown = [.. claims.Compared, .. _ours];
        return new Figure(claims.Number, claims.Title)
        {
            Claim = claims.Claim,
            Criteria = claims.Criteria(swing),
            Beyond = _ours.Count == 0 ? null : Beyond(claims, swing, random),
            Conditions = SweepFigureTexts.Conditions(_axis.Column.Label, _limits.Velocity, _limits.Acceleration, _limits.Jerk),
            Table = TableOf(shown, swing, random),
            Plots = [new FigurePlot("RMS error", _axis.Column, new FigureColumn("RMS error", "mm"),
                [.. shown.Select(name => new PlotTrace(name, Looks.Of(name), swing.Values, [.. swing.RmsMm(name)]) { Marked = true })]) { FromZero = true }],
        };
    }

    FigureTable TableOf(string[] shown, SweepData swing, SweepData random)
    {
        string[] all = ["hold", .. shown];
        string[] ratios = ["quadratic", .. _ours];
        var table = new FigureTable([
            _axis.Column,
            .. all.Select(name => new FigureColumn($"{name} RMS", "mm")),
            .. shown.Select(name => new FigureColumn($"{name} ratio")),
            .. ratios.Select(name => new FigureColumn(SweepFigureTexts.RandomRatio(name)))]);
        for (var i = 0; i < swing.Values.Count; i++)
        {
            var row = i;
            table.Add([swing.Values[row], .. all.Select(name => (double?)swing.RmsMm(name)[row]), .. shown.Select(name => (double?)swing.Ratio(name, row)),
                .. ratios.Select(name => (double?)random.Ratio(name, row))]);
        }
        return table;
    }

    string Beyond(SweepClaims claims, SweepData swing, SweepData random)
    {
        string Of(string name) => SweepFigureTexts.Leaves(name, Shares(name, swing, i => swing.RmsMm("quadratic")[i]), Shares(name, swing, i => claims.Compared.Min(other => swing.RmsMm(other)[i])), Shares(name, random, i => random.RmsMm("quadratic")[i]));
        return SweepFigureTexts.Beyond(string.Concat(_ours.Select(Of)), Motions.SwingPeriod(_limits.Move()));
    }

    static string Shares(string name, SweepData data, Func<int, double> of)
    {
        var shares = Enumerable.Range(0, data.Values.Count).Select(i => data.RmsMm(name)[i] / of(i)).ToArray();
        return $"{Numbers.Text(Math.Round(100 * shares.Min()))} to {Numbers.Percent(Math.Round(shares.Max(), 2))}";
    }
}
