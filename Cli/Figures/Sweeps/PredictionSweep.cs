using Nowpose.Cli.Studies;

namespace Nowpose.Cli.Figures.Sweeps;

/// <summary>Evaluates several predictors on one motion for each value of one condition.</summary>
sealed class PredictionSweep
{
    readonly SweepAxis _axis;
    readonly IReadOnlyList<string> _predictors;
    readonly ErrorComparison[,] _results;

    /// <param name="predictors">One predictor or more. Hold is always added.</param>
    public PredictionSweep(SweepAxis axis, FigureSettings settings, AxisMotion motion, IReadOnlyList<string> predictors)
    {
        _axis = axis;
        _predictors = predictors;
        _results = new ErrorComparison[_predictors.Count, axis.Values.Count];
        Work = [.. from p in Enumerable.Range(0, _predictors.Count) from v in Enumerable.Range(0, axis.Values.Count)
            select (Action)(() => _results[p, v] = PredictionStudy.Run(
                motion, axis.With(settings.Study, axis.Values[v]), () => FigureSettings.Predictor(_predictors[p])))];
    }

    public IReadOnlyList<Action> Work { get; }

    public SweepData Data()
    {
        double[] Of(Func<int, double> rms) => [.. Enumerable.Range(0, _axis.Values.Count).Select(rms)];
        var all = _predictors.Select((name, p) => (Name: name, Rms: Of(v => _results[p, v].Rms)))
            .Prepend((Name: "hold", Rms: Of(v => _results[0, v].RmsHold)));
        return new SweepData(_axis.Values, all.ToDictionary(e => e.Name, e => e.Rms));
    }
}
