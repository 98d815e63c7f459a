using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Studies;
using Nowpose.Motion;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures;

/// <summary>Fig. 12: the 7-phase profile of Figs 13 and 14 as it is sampled, delayed and predicted.</summary>
sealed class Figure12 : IFigureStudy
{
    const double MsPerS = 1000;

    static readonly MotionLimits Limits = MotionLimits.Default;

    /// <summary>Start of the second forward move of the swing, s. All signals have a history by then.</summary>
    const double Start = 2.4;

    /// <summary>Number of plotted instants per second: four per frame, so that steps look vertical.</summary>
    const double DrawnRateHz = 240;

    /// <summary>Maximum age of the sample that a frame shows, L + T_s, s.</summary>
    const double Lag = 0.150;

    static readonly string[] Shown = ["quadratic", .. FigureSettings.OurPredictors];

    readonly StudyFrame[][] _frames = new StudyFrame[Shown.Length][];

    public Figure12(FigureSettings settings) => Work = [.. Shown.Select((name, p) => (Action)(() => _frames[p] = [.. PredictionStudy.Frames(
        Motions.PaperSwing(Start + 1.15), settings.Study with { FrameRateHz = DrawnRateHz, WarmUp = Start - 0.1 }, FigureSettings.Predictor(name), 0)]))];

    public IReadOnlyList<Action> Work { get; }

    public IEnumerable<Figure> Figures()
    {
        var table = TableOfFrames();
        var steady = _frames[0].Where(f => Math.Abs(Motions.PaperMove.AccelerationAt(f.Time - Start)) < 1e-6
            && Motions.PaperMove.VelocityAt(f.Time - Start - Lag) > Limits.Velocity - 1e-6).Select(f => f.Truth - f.Held).ToArray();
        yield return new Figure("12", "The test signal")
        {
            Claim = Figure12Texts.Claim,
            Criteria = Criteria(Motions.PaperMove, steady),
            Conditions = Figure12Texts.Conditions(Limits.Velocity, Limits.Acceleration, Limits.Jerk),
            Table = table,
            Plots = [.. PlotsOf(table)],
        };
    }

    /// <param name="lagMm">Distances by which hold lags behind at full speed, mm.</param>
    public static IReadOnlyList<Criterion> Criteria(SevenPhaseProfile move, IReadOnlyCollection<double> lagMm)
    {
        double[] ms = [.. Enumerable.Range(0, (int)(move.Duration * MsPerS)).Select(i => (i + 0.5) / MsPerS)];
        var (v, a, j) = (ms.Max(t => Math.Abs(move.VelocityAt(t))), ms.Max(t => Math.Abs(move.AccelerationAt(t))), ms.Max(t => Math.Abs(JerkAt(move, t))));
        var phases = 1 + ms.Skip(1).Count(t => Math.Abs(JerkAt(move, t) - JerkAt(move, t - 1 / MsPerS)) > Limits.Jerk / 2);
        return
        [
            new(Figure12Texts.SevenPhases, phases == 7, $"it has {phases}"),
            new(Figure12Texts.Limits,
                v <= 1.001 * Limits.Velocity && a <= 1.001 * Limits.Acceleration && j <= 1.001 * Limits.Jerk,
                FormattableString.Invariant($"{v:0} mm/s, {a:0} mm/s², {j:0} mm/s³")),
            new(Figure12Texts.Hold, lagMm.Min() >= 99.9 && lagMm.Max() <= 150.1,
                $"by {Text(lagMm.Min())} to {Mm(lagMm.Max())}"),
        ];
    }

    static double JerkAt(SevenPhaseProfile move, double t)
    {
        const double step = 1e-5;
        return (move.AccelerationAt(t + step) - move.AccelerationAt(t - step)) / (2 * step);
    }

    FigureTable TableOfFrames()
    {
        var table = new FigureTable([new FigureColumn("time", "ms"), new FigureColumn("velocity share"), new FigureColumn("acceleration share"),
            new FigureColumn("jerk share"), new FigureColumn("truth", "mm"), new FigureColumn("hold", "mm"), .. Shown.Select(name => new FigureColumn(name, "mm"))]);
        for (var i = 0; i < _frames[0].Length; i++)
        {
            var (frame, t) = (_frames[0][i], _frames[0][i].Time - Start);
            table.Add([MsPerS * t, Motions.PaperMove.VelocityAt(t) / Limits.Velocity, Motions.PaperMove.AccelerationAt(t) / Limits.Acceleration,
                JerkAt(Motions.PaperMove, t) / Limits.Jerk, frame.Truth, frame.Held, .. _frames.Select(f => (double?)f[i].Predicted)]);
        }
        return table;
    }

    static IEnumerable<FigurePlot> PlotsOf(FigureTable table)
    {
        yield return new FigurePlot("Position", table.Columns[0], new FigureColumn("position", "mm"),
        [
            table.Trace("ground truth", Looks.Truth, 0, 4),
            table.Trace("uncompensated", Looks.Hold, 0, 5),
            .. Shown.Select((name, p) => table.Trace(name, Looks.Of(name), 0, 6 + p)),
        ]);
        yield return new FigurePlot(Figure12Texts.Derivatives, table.Columns[0], new FigureColumn(Figure12Texts.Share),
            [table.Trace("velocity", Looks.Truth, 0, 1), table.Trace("acceleration", Looks.Cubic, 0, 2), table.Trace("jerk", Looks.Linear, 0, 3)]);
    }
}
