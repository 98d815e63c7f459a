using Nowpose.Sync;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>A clock estimator with its name on the command line.</summary>
sealed record ClockMethod(string Name)
{
    /// <summary>
    /// The paper's estimator with the constants of its Fig. 8 (100 exchanges, 20 hypotheses, moving average of 20), then our estimators.
    /// </summary>
    public static IReadOnlyList<ClockMethod> All { get; } = [new(ClockEstimators.Ransac), new(ClockEstimators.Default)];

    public IClockEstimator Create() => ClockEstimators.Create(Name);
}
