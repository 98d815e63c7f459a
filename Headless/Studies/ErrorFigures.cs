namespace Nowpose.Studies;

/// <summary>Root mean square, 95th percentile and maximum of absolute errors.</summary>
public readonly record struct ErrorFigures(double Rms, double P95, double Maximum)
{
    /// <param name="errors">At least one error. Afterwards, the list is sorted by absolute value.</param>
    public static ErrorFigures Of(List<double> errors)
    {
        var squares = 0.0;
        for (var i = 0; i < errors.Count; i++)
        {
            squares += errors[i] * errors[i];
            errors[i] = Math.Abs(errors[i]);
        }
        errors.Sort();
        return new ErrorFigures(Math.Sqrt(squares / errors.Count), errors[(int)(0.95 * (errors.Count - 1))], errors[^1]);
    }
}
