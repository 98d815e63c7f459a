namespace Nowpose.Cli.Studies;

/// <summary>Root mean square, 95th percentile and maximum of absolute errors.</summary>
public readonly record struct ErrorFigures(double Rms, double P95, double Maximum)
{
    /// <param name="errors">The errors; at least one.</param>
    public static ErrorFigures Of(IReadOnlyList<double> errors) => new(
        Math.Sqrt(errors.Average(error => error * error)), Quantile.Of(errors.Select(Math.Abs), 0.95), errors.Max(Math.Abs));
}
