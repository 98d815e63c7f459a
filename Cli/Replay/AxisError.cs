namespace Nowpose.Cli.Replay;

/// <summary>Collects the errors of hold and of the prediction for one axis, and computes the results.</summary>
sealed class AxisError
{
    readonly List<double> _predicted = [];
    double _squares;
    double _heldSquares;
    int _known;
    double _deviations;
    int _insideOne;
    int _insideTwo;

    /// <summary>Number of frames added so far.</summary>
    public int Count => _predicted.Count;

    /// <param name="deviation">Standard deviation that the predictor states for this prediction; NaN if unknown.</param>
    public void Add(double held, double predicted, double deviation)
    {
        _heldSquares += held * held;
        _squares += predicted * predicted;
        var size = Math.Abs(predicted);
        _predicted.Add(size);
        if (double.IsNaN(deviation)) return;
        _known++;
        _deviations += deviation;
        if (size <= deviation) _insideOne++;
        if (size <= 2 * deviation) _insideTwo++;
    }

    public ReplayResult.Axis Summary(string name)
    {
        var count = _predicted.Count;
        return new ReplayResult.Axis(
            name, Math.Sqrt(_heldSquares / count), Math.Sqrt(_squares / count), Quantile.Of(_predicted, 0.95), _predicted.Max())
        {
            Deviation = _known == 0 ? null
                : new ReplayResult.Deviation(_deviations / _known, (double)_insideOne / _known, (double)_insideTwo / _known),
        };
    }
}
