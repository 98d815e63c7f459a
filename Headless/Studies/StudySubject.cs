using Nowpose.Prediction;

namespace Nowpose.Studies;

/// <summary>Subject of a study: a predictor, or an object that contains one.</summary>
/// <param name="Add">Takes a sample and the newest displayed time, s; NaN before the first frame.</param>
/// <param name="At">Gets the position at a time, s.</param>
/// <param name="Hold">Gets the newest sample's position.</param>
public sealed record StudySubject(Action<JointSample, double> Add, Func<double, double> At, Func<double> Hold)
{
    public static implicit operator StudySubject(JointPredictor predictor) =>
        new((sample, displayed) => predictor.Add(sample, displayed), time => predictor.At(time).Position, () => predictor.Hold);
}
