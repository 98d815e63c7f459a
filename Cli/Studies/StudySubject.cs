using Nowpose.Prediction;

namespace Nowpose.Cli.Studies;

/// <summary>The object under test: a predictor, or an object that contains a predictor.</summary>
/// <param name="Add">Adds a sample. The second argument is the newest displayed time, s; NaN before the first frame.</param>
/// <param name="At">Returns the predicted position at a given time, s.</param>
/// <param name="Hold">Gets the position of the newest sample.</param>
public sealed record StudySubject(Action<JointSample, double> Add, Func<double, double> At, Func<double> Hold)
{
    public static implicit operator StudySubject(JointPredictor predictor) =>
        new((sample, displayed) => predictor.Add(sample, displayed), time => predictor.At(time).Position, () => predictor.Hold);
}
