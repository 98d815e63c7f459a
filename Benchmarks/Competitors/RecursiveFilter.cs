using Nowpose.Prediction.Forecasting;

namespace Nowpose.Benchmarks.Competitors;

/// <summary>What filters have in common that know their last state only: a sample that was overtaken comes too late for them.</summary>
abstract class RecursiveFilter : Forecaster
{
    bool _hasStarted;

    /// <summary>The newest one, and the one before for the interval.</summary>
    public override int Samples => 2;

    /// <summary>Position of the sample before the one that <see cref="Update"/> takes.</summary>
    protected double Newest { get; private set; }

    public override bool Solve(MotionState motion)
    {
        if (!motion.IsNewest) return true;
        var position = motion.Samples.NewestPosition;
        if (_hasStarted) Update(motion.Interval, position);
        else Start(position);
        Newest = position;
        return _hasStarted = true;
    }

    public override double At(double ahead) => PositionAt(ahead) - Newest;

    public override void Reset() => _hasStarted = false;

    /// <summary>The first sample: nothing else is known.</summary>
    protected abstract void Start(double position);

    /// <param name="interval">Since the sample before, s, positive.</param>
    protected abstract void Update(double interval, double position);

    /// <param name="ahead">Of the newest sample, s.</param>
    protected abstract double PositionAt(double ahead);
}
