namespace Nowpose.Cli.Replay;

/// <summary>Collects the errors of one axis, and the standard deviations that the predictor states.</summary>
sealed class AxisError
{
    readonly ErrorCollector _errors = new();
    int _known;
    double _deviations;
    int _insideOne;
    int _insideTwo;

    /// <summary>Number of frames added so far.</summary>
    public int Count => _errors.Count;

    /// <param name="deviation">Standard deviation that the predictor states for this prediction; NaN if unknown.</param>
    public void Add(double held, double predicted, double deviation)
    {
        _errors.Add(held, predicted);
        if (double.IsNaN(deviation)) return;
        _known++;
        _deviations += deviation;
        if (Math.Abs(predicted) <= deviation) _insideOne++;
        if (Math.Abs(predicted) <= 2 * deviation) _insideTwo++;
    }

    public ReplayResult.Axis Summary(string name) => new(name, _errors.Result())
    {
        Deviation = _known == 0 ? null : new ReplayResult.Deviation(_deviations / _known, (double)_insideOne / _known, (double)_insideTwo / _known),
    };
}
