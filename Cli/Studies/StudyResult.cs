namespace Nowpose.Cli.Studies;

/// <summary>Errors over all scored frames, in the unit of the motion.</summary>
public sealed record StudyResult(ErrorFigures Predicted, ErrorFigures Held)
{
    /// <summary>RMS error of the prediction divided by the RMS error of hold; NaN for a motion at rest.</summary>
    public double Ratio => Predicted.Rms / Held.Rms;
}
