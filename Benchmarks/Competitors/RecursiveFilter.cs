using Nowpose.Prediction;

namespace Nowpose.Benchmarks.Competitors;

/// <summary>What filters have in common that know their last state only: a sample that was overtaken comes too late for them.</summary>
public abstract class RecursiveFilter : IJointPredictor
{
    const double DuplicateSeconds = 1e-6;

    public double Hold { get; private set; }

    public double NewestTime { get; private set; } = double.NegativeInfinity;

    public SampleOutcome Add(in JointSample sample)
    {
        var interval = sample.Time - NewestTime;
        if (Math.Abs(interval) < DuplicateSeconds) return SampleOutcome.Duplicate;
        if (interval < 0) return SampleOutcome.TooOld;
        if (double.IsPositiveInfinity(interval)) Start(sample.Position);
        else Update(interval, sample.Position);
        Hold = sample.Position;
        NewestTime = sample.Time;
        return SampleOutcome.Accepted;
    }

    public JointPrediction At(double time) => double.IsNegativeInfinity(NewestTime)
        ? default
        : new JointPrediction(PositionAt(time - NewestTime), PredictionKind.Predicted);

    public void Reset()
    {
        Hold = 0;
        NewestTime = double.NegativeInfinity;
    }

    /// <summary>The first sample: nothing else is known.</summary>
    protected abstract void Start(double position);

    /// <param name="interval">Since the sample before, s, positive.</param>
    protected abstract void Update(double interval, double position);

    /// <param name="ahead">Of the newest sample, s.</param>
    protected abstract double PositionAt(double ahead);
}
