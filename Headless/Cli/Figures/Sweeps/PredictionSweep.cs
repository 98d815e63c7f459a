using Nowpose.Studies;

namespace Nowpose.Cli.Figures.Sweeps;

/// <summary>Predicts the paper's swing by each predictor under each value of one condition.</summary>
sealed class PredictionSweep
{
    static readonly string[] OfThePaper = ["linear", "quadratic", "cubic", "quadratic-h3", "quadratic-h4"];

    readonly SweepAxis _axis;
    readonly IReadOnlyList<string> _predictors;
    readonly StudyResult[,] _results;

    public PredictionSweep(SweepAxis axis, FigureSettings settings)
    {
        _axis = axis;
        _predictors = [.. OfThePaper, .. FigureSettings.OurPredictors];
        _results = new StudyResult[_predictors.Count, axis.Values.Count];
        var motion = Motions.PaperSwing(settings.SwingSeconds);
        Work = [.. from p in Enumerable.Range(0, _predictors.Count) from v in Enumerable.Range(0, axis.Values.Count)
            select (Action)(() => _results[p, v] = PredictionStudy.Run(
                motion, axis.With(settings.Study, axis.Values[v]), () => FigureSettings.Predictor(_predictors[p])))];
    }

    public SweepAxis Axis => _axis;

    public IReadOnlyList<Action> Work { get; }

    public SweepData Data()
    {
        double[] Of(Func<int, double> rms) => [.. Enumerable.Range(0, _axis.Values.Count).Select(rms)];
        var all = _predictors.Select((name, p) => (name, Rms: Of(v => _results[p, v].Predicted.Rms)))
            .Prepend(("hold", Of(v => _results[0, v].Held.Rms)));
        return new SweepData(_axis.Values, all.ToDictionary(e => e.Item1, e => e.Item2));
    }
}
