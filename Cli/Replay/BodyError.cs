namespace Nowpose.Cli.Replay;

/// <summary>Collects the errors of hold and of the prediction for the position or rotation of a body, and computes the results.</summary>
sealed class BodyError
{
    readonly List<double> _predicted = [];
    double _squares;
    double _heldSquares;

    /// <summary>Adds the absolute errors of one frame.</summary>
    public void Add(double held, double predicted)
    {
        _heldSquares += held * held;
        _squares += predicted * predicted;
        _predicted.Add(predicted);
    }

    /// <param name="scale">Factor that converts the unit of the added errors to the unit of the result.</param>
    public BodyReplayResult.ErrorSize Summary(double scale) => new(
        scale * Math.Sqrt(_heldSquares / _predicted.Count), scale * Math.Sqrt(_squares / _predicted.Count),
        scale * Quantile.Of(_predicted, 0.95), scale * _predicted.Max());
}
