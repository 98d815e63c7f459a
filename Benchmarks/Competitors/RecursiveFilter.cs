using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;

namespace Nowpose.Benchmarks.Competitors;

/// <summary>Base class of filters that store only their last state. They cannot use a sample that arrives after a newer one.</summary>
abstract class RecursiveFilter : Forecaster
{
    bool _hasStarted;

    /// <summary>Number of samples needed: the newest one, and the previous one for the interval.</summary>
    public override int UsedSamples => 2;

    /// <summary>Position of the last processed sample. In <see cref="Update"/>, this is the previous sample.</summary>
    protected double Newest { get; private set; }

    public override bool Solve(MotionState motion)
    {
        if (!motion.IsNewest) return true;
        var position = motion.Newest[0];
        if (_hasStarted) Update(motion.Timing.Interval, position);
        else Start(position);
        Newest = position;
        return _hasStarted = true;
    }

    public override double At(double ahead, int component) => PositionAt(ahead) - Newest;

    public override void Reset() => _hasStarted = false;

    /// <summary>Initialises the filter with the first sample.</summary>
    protected abstract void Start(double position);

    /// <param name="interval">Time since the previous sample, s; positive.</param>
    protected abstract void Update(double interval, double position);

    /// <param name="ahead">Time after the newest sample, s.</param>
    protected abstract double PositionAt(double ahead);
}
