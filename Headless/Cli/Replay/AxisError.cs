namespace Nowpose.Cli.Replay;

/// <summary>Collects one axis' errors, held and predicted, and sums them up.</summary>
sealed class AxisError
{
    readonly List<double> _predicted = [];
    double _squares;
    double _heldSquares;

    /// <summary>Frames so far.</summary>
    public int Count => _predicted.Count;

    public void Add(double held, double predicted)
    {
        _heldSquares += held * held;
        _squares += predicted * predicted;
        _predicted.Add(Math.Abs(predicted));
    }

    public ReplayResult.Axis Summary(string name)
    {
        var count = _predicted.Count;
        return new ReplayResult.Axis(
            name, Math.Sqrt(_heldSquares / count), Math.Sqrt(_squares / count), Quantile.Of(_predicted, 0.95), _predicted.Max());
    }
}
