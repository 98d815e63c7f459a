using Nowpose.Prediction;

namespace Nowpose.Benchmarks;

/// <summary>A predictor in the middle of a joint's motion: it has seen more of it than any predictor remembers.</summary>
/// <remarks>The motion repeats itself, so that what looks for repetitions finds them: the most work there can be.</remarks>
sealed class SampledJoint
{
    /// <summary>Longer than anything is remembered, s.</summary>
    public const double SecondsSeen = 130;

    const double UsualHorizon = 0.1;

    readonly JointPredictor _predictor;
    readonly double _interval;
    readonly double[] _positions;
    long _samples;
    double _displayed = double.NaN;

    /// <param name="joint">Which of the seven-joint arm's.</param>
    /// <param name="interval">Between samples, s.</param>
    public SampledJoint(JointPredictor predictor, int joint, double interval)
    {
        _predictor = predictor;
        _interval = interval;
        _positions = [.. Enumerable.Range(0, (int)Math.Round(SevenJointArm.PeriodSeconds / interval))
            .Select(sample => SevenJointArm.PositionsAt(sample * interval)[joint])];
        while (_samples * interval < SecondsSeen)
        {
            Add();
            At(UsualHorizon);
        }
    }

    /// <summary>The next sample.</summary>
    public SampleOutcome Add() => _predictor.Add(
        new JointSample(++_samples * _interval, _positions[_samples % _positions.Length]), _displayed);

    /// <param name="ahead">Of the newest sample, s.</param>
    public double At(double ahead) => _predictor.At(_displayed = _samples * _interval + ahead).Position;
}
