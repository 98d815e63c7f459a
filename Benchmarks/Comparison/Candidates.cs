using Nowpose.Benchmarks.Competitors;
using Nowpose.Prediction;
using Nowpose.Prediction.Forecasting;

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
        new("MathNet", () => By(new PolynomialFit())),
        new("Kalman", () => Kalman(1.3e12)),
        new("One-Euro", () => OneEuro(16, 9e-4, 2700)),
        new("double-exponential", () => DoubleExponential(0.0035)),
    ];

    public static Candidate Named(string name) => All.First(candidate => candidate.Name == name);

    /// <param name="jerkToNoise">s⁻⁵.</param>
    public static JointPredictor Kalman(double jerkToNoise) => By(new KalmanFilter(jerkToNoise));

    /// <param name="leastCutoff">Hz.</param>
    /// <param name="slope">Hz per mm/s.</param>
    /// <param name="velocityCutoff">Hz.</param>
    public static JointPredictor OneEuro(double leastCutoff, double slope, double velocityCutoff) =>
        By(new OneEuroFilter(leastCutoff, slope, velocityCutoff));

    /// <param name="timeConstant">s.</param>
    public static JointPredictor DoubleExponential(double timeConstant) => By(new DoubleExponential(timeConstant));

    static JointPredictor By(Forecaster forecaster) =>
        new(forecaster, forecaster.Samples, PredictionParts.None, PredictionLimits.Unlimited, blend: 0);

    static Candidate Ours(string name) => new(name, () => Predictors.Create(name, PredictionLimits.Unlimited));
}
