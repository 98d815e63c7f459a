namespace Nowpose.Cli.Replay;

/// <summary>Collects the mean squared errors of each pass over a motion.</summary>
sealed class PassErrors
{
    readonly List<(double HoldSquares, double Squares, int Frames)> _passes = [];

    /// <summary>Number of the passes that have begun.</summary>
    public int Count => _passes.Count;

    public void Start() => _passes.Add(default);

    /// <summary>Adds the squared errors of a frame to the present pass.</summary>
    public void Add(double holdSquare, double square)
    {
        var pass = _passes[^1];
        _passes[^1] = (pass.HoldSquares + holdSquare, pass.Squares + square, pass.Frames + 1);
    }

    /// <summary>Gets the errors of the passes that have frames.</summary>
    /// <param name="scale">Factor that converts the unit of the added errors to the unit of the result.</param>
    public IReadOnlyList<PassRms> Result(double scale = 1) =>
    [
        .. _passes.Where(pass => pass.Frames > 0)
            .Select(pass => new PassRms(scale * Math.Sqrt(pass.HoldSquares / pass.Frames), scale * Math.Sqrt(pass.Squares / pass.Frames))),
    ];
}

/// <summary>RMS errors of hold and of the prediction in one pass over a motion.</summary>
public readonly record struct PassRms(double RmsHold, double Rms);
