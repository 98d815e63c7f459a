using Nowpose.Benchmarks.Competitors;
using Nowpose.Prediction;

namespace Nowpose.Benchmarks.Comparison;

/// <summary>What is compared: our predictors and those of others, each with its best constants for all conditions together.</summary>
/// <remarks>
/// The constants are what <see cref="Tuning"/> finds on its own seeds, for positions in mm; ours know no limits and have
/// nothing set. None of them, ours included, has seen <see cref="Conditions.CheckingSeeds"/>. Filters come out nearly open:
/// in a prediction 100 ms ahead the lag that smoothing adds weighs more than the noise that it takes off.
/// </remarks>
public static class Candidates
{
    public const string Baseline = "quadratic";

    public static IReadOnlyList<Candidate> All { get; } =
    [
        Ours("hold"), Ours("linear"), Ours(Baseline), Ours(Predictors.Default),
        new("MathNet", () => new PolynomialFitPredictor()),
        new("Kalman", () => Kalman(1.3e12)),
        new("One-Euro", () => OneEuro(16, 9e-4, 2700)),
        new("double-exponential", () => DoubleExponential(0.0035)),
    ];

    public static Candidate Named(string name) => All.First(candidate => candidate.Name == name);

    /// <param name="jerkToNoise">s⁻⁵.</param>
    public static IJointPredictor Kalman(double jerkToNoise) => new KalmanPredictor(jerkToNoise);

    /// <param name="leastCutoff">Hz.</param>
    /// <param name="slope">Hz per mm/s.</param>
    /// <param name="velocityCutoff">Hz.</param>
    public static IJointPredictor OneEuro(double leastCutoff, double slope, double velocityCutoff) =>
        new OneEuroPredictor(leastCutoff, slope, velocityCutoff);

    /// <param name="timeConstant">s.</param>
    public static IJointPredictor DoubleExponential(double timeConstant) => new DoubleExponentialPredictor(timeConstant);

    static Candidate Ours(string name) => new(name, () => Predictors.Create(name, PredictionLimits.Unlimited));
}
