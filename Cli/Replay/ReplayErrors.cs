namespace Nowpose.Cli.Replay;

/// <summary>Collects the errors of all axes over the scored frames of a replay.</summary>
/// <param name="axes">Names of the axes, and their units, which are null if unknown.</param>
sealed class ReplayErrors(IReadOnlyList<(string Name, string Unit)> axes)
{
    readonly AxisError[] _axes = [.. axes.Select(_ => new AxisError())];
    long _frame = -1;

    /// <summary>Number of frames with at least one scored axis.</summary>
    public int Frames { get; private set; }

    public void Add(ScoredValue value)
    {
        if (value.Frame != _frame) Frames++;
        _frame = value.Frame;
        _axes[value.Axis].Add(value.HoldError, value.Error, value.Deviation);
    }

    /// <summary>Gets the errors of all axes that were scored.</summary>
    /// <exception cref="InputException">The errors overflow.</exception>
    public ReplayResult Result(string path, string predictor)
    {
        var scored = _axes.Zip(axes).Where(axis => axis.First.Count > 0);
        var summaries = scored.Select(axis => axis.First.Summary(axis.Second.Name) with { Unit = axis.Second.Unit });
        var result = new ReplayResult(path, predictor, Frames, [.. summaries]);
        return double.IsFinite(result.Rms + result.RmsHold) ? result
            : throw new InputException(ReplayMessages.TooLarge(path, result.Axes.MaxBy(Size).Name));
    }

    // A prediction from values that overflow is not a number.
    static double Size(ReplayResult.Axis axis) =>
        double.IsNaN(axis.Error.Rms) ? double.PositiveInfinity : Math.Max(axis.Error.Rms, axis.Error.RmsHold);
}

/// <summary>The values of one axis in one scored frame, in the unit of the axis.</summary>
/// <param name="Frame">Number of the frame, which increases.</param>
/// <param name="Ticks">Display time, 100 ns: since the first row of a motion, or the control time of a session.</param>
/// <param name="Axis">Index of the axis.</param>
/// <param name="Held">
/// The newest sample that has arrived. For a continuous joint of a session, it and <paramref name="Predicted"/> are within half a turn of the truth.
/// </param>
/// <param name="Deviation">Standard deviation that the predictor states; NaN if unknown.</param>
readonly record struct ScoredValue(long Frame, long Ticks, int Axis, double Truth, double Held, double Predicted, double Deviation)
{
    /// <summary>Number of the pass over a motion, from 1; 1 for a session.</summary>
    public int Pass { get; init; } = 1;

    public double HoldError => Held - Truth;

    public double Error => Predicted - Truth;
}
