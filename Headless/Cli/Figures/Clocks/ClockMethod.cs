using Nowpose.Sync;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>A clock estimator by the name that the command line knows it by.</summary>
sealed record ClockMethod(string Name, Func<IClockEstimator> Create)
{
    /// <summary>The paper's, with the constants of its Fig. 8: 100 exchanges, 20 hypotheses, moving average of 20.</summary>
    public static readonly ClockMethod Paper = Named(ClockEstimators.Ransac);

    public static IReadOnlyList<ClockMethod> All { get; } = [Paper, Named(ClockEstimators.Default)];

    static ClockMethod Named(string name) => new(name, () => ClockEstimators.Create(name));
}
