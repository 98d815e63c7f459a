using Nowpose.Sync;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>A clock estimator, identified by its name on the command line.</summary>
sealed record ClockMethod(string Name)
{
    /// <summary>
    /// All compared estimators: the paper's with the constants of Fig. 8 (100 exchanges, 20 hypotheses, moving average of 20), then our own.
    /// </summary>
    public static IReadOnlyList<ClockMethod> All { get; } = [new(ClockEstimators.Ransac), new(ClockEstimators.Default)];

    public IClockEstimator Create() => ClockEstimators.Create(Name);
}
