namespace Nowpose.Cli;

/// <summary>Collects the errors of hold and of the displayed value frame by frame, and compares them.</summary>
sealed class ErrorCollector
{
    readonly List<double> _sizes = [];
    double _squares;
    double _holdSquares;

    /// <summary>Number of frames added so far.</summary>
    public int Count => _sizes.Count;

    public void Add(double hold, double displayed)
    {
        _holdSquares += hold * hold;
        _squares += displayed * displayed;
        _sizes.Add(Math.Abs(displayed));
    }

    /// <summary>Compares the errors of one frame or more.</summary>
    /// <param name="scale">Factor that converts the unit of the added errors to the unit of the result.</param>
    public ErrorComparison Result(double scale = 1) => new(
        scale * Math.Sqrt(_holdSquares / Count), scale * Math.Sqrt(_squares / Count), scale * Quantile.Of(_sizes, 0.95), scale * _sizes.Max());
}
