namespace Nowpose.Cli.Replay;

/// <summary>The result of a replay; errors in the unit of the recording's columns.</summary>
public sealed class ReplayResult
{
    public ReplayResult(string file, string predictor, int frames, IReadOnlyList<Axis> axes)
    {
        File = file;
        Predictor = predictor;
        Frames = frames;
        Axes = axes;
        RmsHold = Math.Sqrt(axes.Sum(axis => axis.RmsHold * axis.RmsHold));
        Rms = Math.Sqrt(axes.Sum(axis => axis.Rms * axis.Rms));
    }

    /// <summary>Errors of one column: of hold (RMS) and of the prediction (RMS, and P95 and maximum of the absolute error).</summary>
    public readonly record struct Axis(string Name, double RmsHold, double Rms, double P95, double Max)
    {
        /// <summary>Null if the predictor gives no standard deviation.</summary>
        public Deviation? Deviation { get; init; }
    }

    /// <summary>
    /// Standard deviations given by the predictor: their mean, and the shares, 0 to 1, of frames whose absolute error is at most one and
    /// at most two of them. Computed over the frames that have one.
    /// </summary>
    public readonly record struct Deviation(double Mean, double InsideOne, double InsideTwo);

    public string File { get; }

    /// <summary>The moving objects of a session, by the names of their frames; empty for none, and for a motion.</summary>
    public IReadOnlyList<BodyReplayResult> Bodies { get; init; } = [];

    /// <summary>The signals of a session with the number of their changes; empty for none, and for a motion.</summary>
    public IReadOnlyList<(string Name, int Changes)> Signals { get; init; } = [];

    public string Predictor { get; }

    /// <summary>Number of scored frames.</summary>
    public int Frames { get; }

    public IReadOnlyList<Axis> Axes { get; }

    /// <summary>Root of the summed mean squares of all axes, held.</summary>
    public double RmsHold { get; }

    /// <summary>Root of the summed mean squares of all axes, predicted.</summary>
    public double Rms { get; }

    /// <summary>1 − rms / rms_hold; null if hold has no error.</summary>
    public double? Reduction => RmsHold == 0 ? null : 1 - Rms / RmsHold;
}
