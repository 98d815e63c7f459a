namespace Nowpose.Studies;

/// <summary>Errors over all scored frames, in the motion's unit.</summary>
public sealed record StudyResult(ErrorFigures Predicted, ErrorFigures Held)
{
    /// <summary>RMS of the prediction over RMS of hold; NaN for a motion that rests.</summary>
    public double Ratio => Predicted.Rms / Held.Rms;
}
