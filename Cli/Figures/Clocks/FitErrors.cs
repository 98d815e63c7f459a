namespace Nowpose.Cli.Figures.Clocks;

/// <summary>The fitting errors ε_i of Eq. (6) after the clock has settled. The paper achieves |ε_i| below 1 ms.</summary>
static class FitErrors
{
    /// <summary>Bound of the paper, ms.</summary>
    public const double BoundMs = 1;

    /// <summary>Minimum share of the exchanges below the bound. The others are the outliers that RANSAC excludes.</summary>
    public const double MinShare = 0.95;

    public const string Claim = "From 10 s on, the fitting error |ε_i| of Eq. (6) is below 1 ms: share of all exchanges, 95 % or more.";

    /// <summary>Gets |ε_i| of the exchanges from <see cref="ClockErrors.SettledAfter"/> on, ms.</summary>
    public static double[] Of(IEnumerable<SyncStep> steps) =>
        [.. steps.Where(step => step.Seconds >= ClockErrors.SettledAfter && step.FitErrorMs.HasValue).Select(step => Math.Abs(step.FitErrorMs.Value))];

    /// <param name="errors">At least one error.</param>
    public static double ShareBelow(double[] errors) => (double)errors.Count(ms => ms < BoundMs) / errors.Length;
}
