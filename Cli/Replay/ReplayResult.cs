namespace Nowpose.Cli.Replay;

/// <summary>The result of a replay. Errors are in the unit of the recording's columns.</summary>
public sealed record ReplayResult
{
    public ReplayResult(string file, string predictor, int frames, IReadOnlyList<Axis> axes)
    {
        File = file;
        Predictor = predictor;
        Frames = frames;
        Axes = axes;
        var all = Total.Of(null, axes);
        (RmsHold, Rms) = (all.RmsHold, all.Rms);
        var units = axes.GroupBy(axis => axis.Unit).ToList();
        if (units.Count > 1) Totals = [.. units.Select(unit => Total.Of(unit.Key, unit))];
    }

    /// <summary>Errors of one column.</summary>
    public readonly record struct Axis(string Name, ErrorComparison Error)
    {
        /// <summary>Unit of the errors, rad or m; null if the file does not state it.</summary>
        public string Unit { get; init; }

        /// <summary>Standard deviations that the predictor states; null if it states none.</summary>
        public Deviation? Deviation { get; init; }
    }

    /// <summary>Square root of the sum of the mean squared errors of the axes with one unit, for hold and for the prediction.</summary>
    public readonly record struct Total(string Unit, double RmsHold, double Rms)
    {
        /// <inheritdoc cref="ReplayResult.Reduction"/>
        public double? Reduction => ErrorReduction.Of(Rms, RmsHold);

        internal static Total Of(string unit, IEnumerable<Axis> axes) => new(
            unit, Math.Sqrt(axes.Sum(axis => axis.Error.RmsHold * axis.Error.RmsHold)), Math.Sqrt(axes.Sum(axis => axis.Error.Rms * axis.Error.Rms)));
    }

    /// <summary>
    /// Standard deviations that the predictor states: their mean, their root mean square, and the coverage of all frames and of those in which
    /// hold has an error of more than 0.001 in the unit of the axis. Frames without a standard deviation are ignored.
    /// </summary>
    public readonly record struct Deviation(double Mean, double Rms, Coverage All, Coverage Moving);

    /// <summary>
    /// Shares, 0 to 1, of frames whose absolute error is at most one or at most two standard deviations; null without frames.
    /// </summary>
    public readonly record struct Coverage(int Frames, double? InsideOne, double? InsideTwo);

    public string File { get; }

    /// <summary>Results of a session's moving objects, sorted by the names of their frames; empty if there are none.</summary>
    public IReadOnlyList<BodyReplayResult> Bodies { get; init; } = [];

    /// <summary>A session's signals with the number of their changes; empty if there are none.</summary>
    public IReadOnlyList<(string Name, int Changes)> Signals { get; init; } = [];

    public string Predictor { get; }

    /// <summary>Number of scored frames.</summary>
    public int Frames { get; }

    public IReadOnlyList<Axis> Axes { get; }

    /// <summary>Totals for each unit; empty if all axes have the same unit, or if the file does not state the units.</summary>
    public IReadOnlyList<Total> Totals { get; } = [];

    /// <summary>Results of each pass over a motion; empty for a session.</summary>
    public IReadOnlyList<PassRms> Passes { get; init; } = [];

    /// <summary>
    /// RMS error of hold: square root of the sum of all axes' mean squared errors. Different units are added like equal ones.
    /// </summary>
    public double RmsHold { get; }

    /// <summary>RMS error of the prediction: square root of the sum of all axes' mean squared errors.</summary>
    public double Rms { get; }

    /// <summary>1 − Rms / RmsHold; null if hold has no error.</summary>
    public double? Reduction => ErrorReduction.Of(Rms, RmsHold);
}
