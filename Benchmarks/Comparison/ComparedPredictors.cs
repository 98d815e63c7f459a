using Nowpose.Benchmarks.Competitors;
using Nowpose.Prediction;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Benchmarks.Comparison;

/// <summary>The compared predictors: those of Nowpose and others. The others have the constants that are best for all conditions together.</summary>
/// <remarks>
/// The constants are results of <see cref="Tuning"/> with its own seeds, for positions in mm. Nowpose's predictors have default settings
/// and no limits. No predictor was tuned with <see cref="ComparedMotions.CheckingSeeds"/>. The tuned filters smooth very little: in a
/// prediction 100 ms ahead, the lag caused by smoothing outweighs the reduction of the noise.
/// </remarks>
public static class ComparedPredictors
{
    public const string Baseline = "quadratic";

    public static IReadOnlyList<ComparedPredictor> All { get; } =
    [
        Ours("hold"), Ours("linear"), Ours(Baseline), Ours(Predictors.Default),
        new("MathNet", () => By(new PolynomialFit())),
        new("Kalman", () => Kalman(1.3e12)),
        new("One-Euro", () => OneEuro(16, 9e-4, 2700)),
        new("double-exponential", () => DoubleExponential(0.0035)),
    ];

    public static ComparedPredictor Named(string name) => All.First(candidate => candidate.Name == name);

    /// <param name="jerkToNoise">Spectral density of the jerk divided by the variance of a position, s⁻⁵.</param>
    public static JointPredictor Kalman(double jerkToNoise) => By(new KalmanFilter(jerkToNoise));

    /// <param name="minCutoff">Minimum cut-off frequency, Hz.</param>
    /// <param name="slope">Slope of the cut-off frequency, Hz per mm/s.</param>
    /// <param name="velocityCutoff">Cut-off frequency of the velocity, Hz.</param>
    public static JointPredictor OneEuro(double minCutoff, double slope, double velocityCutoff) =>
        By(new OneEuroFilter(minCutoff, slope, velocityCutoff));

    /// <param name="timeConstant">Time constant, s.</param>
    public static JointPredictor DoubleExponential(double timeConstant) => By(new DoubleExponential(timeConstant));

    static JointPredictor By(Forecaster forecaster) => Predictors.Of(forecaster, forecaster.UsedSamples, PredictionLimits.Unlimited);

    static ComparedPredictor Ours(string name) => new(name, () => Predictors.Create(name, PredictionLimits.Unlimited));
}
