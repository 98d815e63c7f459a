namespace Nowpose.Benchmarks.Competitors;

/// <summary>Double exponential smoothing as a predictor (LaViola 2003). Extrapolates a line from the positions smoothed once and twice.</summary>
/// <remarks>The method requires equal intervals, so a missing sample is replaced by linear interpolation.</remarks>
/// <param name="timeConstant">Time in which the weight of a sample falls to 1/e, s. α is computed from this time and the interval.</param>
sealed class DoubleExponential(double timeConstant) : RecursiveFilter
{
    const double IntervalLearning = 0.05;
    const int MaxSteps = 10;

    double _interval, _share, _once, _twice;

    protected override void Start(double position) => (_interval, _once, _twice) = (0, position, position);

    protected override void Update(double interval, double position)
    {
        var isSecond = _interval == 0;
        var steps = isSecond ? 1 : Math.Clamp((int)Math.Round(interval / _interval), 1, MaxSteps);
        _interval += (isSecond ? 1 : IntervalLearning) * (interval / steps - _interval);
        _share = 1 - Math.Exp(-_interval / timeConstant);
        if (isSecond) Begin(position);
        else
            for (var step = 1; step <= steps; step++) Smooth(Newest + (position - Newest) * step / steps);
    }

    protected override double PositionAt(double ahead) => 2 * _once - _twice + Slope * ahead;

    double Slope => _interval > 0 ? _share / (1 - _share) * (_once - _twice) / _interval : 0;

    void Smooth(double position)
    {
        _once += _share * (position - _once);
        _twice += _share * (_once - _twice);
    }

    // Initialises the filter as if all earlier samples had been on the line through the first two samples.
    void Begin(double position)
    {
        var lag = (1 - _share) / _share * (position - Newest);
        _once = position - lag;
        _twice = position - 2 * lag;
    }
}
