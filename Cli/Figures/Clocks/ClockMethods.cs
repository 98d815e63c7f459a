using Nowpose.Sync;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Lists the compared clock estimators by their names on the command line.</summary>
static class ClockMethods
{
    /// <summary>The paper's estimator with the constants of Fig. 8 (100 exchanges, 20 hypotheses, moving average of 20), then our own.</summary>
    public static IReadOnlyList<string> All { get; } = [ClockEstimators.Ransac, ClockEstimators.Default];
}
