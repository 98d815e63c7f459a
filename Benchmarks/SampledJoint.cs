using Nowpose.Prediction;

namespace Nowpose.Benchmarks;

/// <summary>A joint in motion whose predictor has a full history.</summary>
/// <remarks>The motion is periodic, so the search for repetitions succeeds, which causes the maximum amount of work.</remarks>
sealed class SampledJoint
{
    /// <summary>Duration of the motion before the measurement, s. Longer than the history of any predictor.</summary>
    public const double SecondsSeen = 130;

    const double UsualHorizon = 0.1;

    readonly JointPredictor _predictor;
    readonly double _interval;
    readonly double[] _positions;
    long _samples;
    double _displayed = double.NaN;

    /// <param name="joint">Index of the joint of the seven-joint arm.</param>
    /// <param name="interval">Sampling interval, s.</param>
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

    /// <summary>Adds the next sample.</summary>
    public DropReason Add() => _predictor.Add(
        new JointSample(++_samples * _interval, _positions[_samples % _positions.Length]), _displayed);

    /// <param name="ahead">Time after the newest sample, s.</param>
    public double At(double ahead) => _predictor.At(_displayed = _samples * _interval + ahead).Position;
}
