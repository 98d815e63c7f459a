namespace Nowpose.Cli.Replay;

/// <summary>Collects one axis' errors, held and predicted, and sums them up.</summary>
sealed class AxisError
{
    readonly List<double> _predicted = [];
    double _squares;
    double _heldSquares;

    public void Add(double held, double predicted)
    {
        _heldSquares += held * held;
        _squares += predicted * predicted;
        _predicted.Add(Math.Abs(predicted));
    }

    public ReplayResult.Axis Summary(string name)
    {
        _predicted.Sort();
        var count = _predicted.Count;
        return new ReplayResult.Axis(
            name, Math.Sqrt(_heldSquares / count), Math.Sqrt(_squares / count), Quantile(0.95), _predicted[^1]);
    }

    /// <summary>Linear between order statistics: the q-quantile of n values stands at rank q (n − 1).</summary>
    double Quantile(double q)
    {
        var rank = q * (_predicted.Count - 1);
        var below = (int)rank;
        var above = Math.Min(below + 1, _predicted.Count - 1);
        return _predicted[below] + (_predicted[above] - _predicted[below]) * (rank - below);
    }
}
