using Nowpose.Cli.Studies;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Prediction;

/// <summary>
/// Tests the error of <c>adaptive</c> on motions that were not used for tuning. Its constants were chosen with seeds 1000 to 1006 and
/// recordings of real machines; the tests use seeds 9001 to 9003. The limits are those documented for the default predictor.
/// </summary>
public class AdaptiveAccuracyTests
{
    static readonly int[] Seeds = [9001, 9002, 9003];
    static readonly string[] Fixed = ["hold", "linear", "quadratic", "quadratic-h3", "quadratic-h4", "cubic"];

    static readonly StudySettings Usual = new() { Phases = 2 };

    static StudySettings At(double samplingMs, double latencyMs) =>
        Usual with { SamplingInterval = samplingMs / 1000, Latency = latencyMs / 1000 };

    [TestCase(20, 100, 0.65)]
    [TestCase(50, 100, 0.65)]
    [TestCase(100, 150, 0.80)]
    public void Adaptive_FastMoves_IsMoreAccurateThanTheQuadratic(double samplingMs, double latencyMs, double limit) =>
        Assert.That(OverQuadratic(seed => Motions.FastMoves(seed), At(samplingMs, latencyMs)), Is.LessThan(limit), Message);

    [TestCase(20, 100)]
    [TestCase(50, 100)]
    [TestCase(100, 150)]
    public void Adaptive_GentleMoves_IsMoreAccurateThanTheQuadratic(double samplingMs, double latencyMs) =>
        Assert.That(OverQuadratic(seed => Motions.GentleMoves(seed), At(samplingMs, latencyMs)), Is.LessThan(0.80), Message);

    [TestCase(20, 100)]
    [TestCase(50, 100)]
    [TestCase(100, 150)]
    public void Adaptive_SlowAndCurvedMotions_IsCloseToTheBestFixedPredictor(double samplingMs, double latencyMs)
    {
        Assert.That(OverBest(seed => Motions.SoftMoves(seed), At(samplingMs, latencyMs)), Is.LessThan(1.05), "soft moves, " + Message);
        Assert.That(OverBest(seed => Motions.Trapezoids(seed), At(samplingMs, latencyMs)), Is.LessThan(1.00), "trapezoids, " + Message);
        Assert.That(OverBest(seed => Motions.Waves(seed), At(samplingMs, latencyMs)), Is.LessThan(0.60), "sum of sines, " + Message);
    }

    [TestCase(20, 100)]
    [TestCase(50, 100)]
    [TestCase(100, 150)]
    public void Adaptive_EmergencyStopsRingingAndJumps_IsMoreAccurateThanTheQuadratic(double samplingMs, double latencyMs)
    {
        foreach (var motionOf in new Func<int, AxisMotion>[] { s => Motions.EmergencyStops(s), s => Motions.Ringing(s), s => Motions.Jumps(s) })
        {
            Assert.That(Ratio(motionOf, At(samplingMs, latencyMs)), Is.LessThan(3), motionOf(1).Name + " against hold, " + Message);
            Assert.That(OverQuadratic(motionOf, At(samplingMs, latencyMs)), Is.LessThan(0.75), motionOf(1).Name + ", " + Message);
        }
    }

    // In fast moves, the error is 0.26 times that of the quadratic predictor even without stamp errors, so errors of ±10 ms are corrected completely.
    [TestCase(5, 0.46, 0.45)]
    [TestCase(10, 0.28, 0.25)]
    public void Adaptive_StampErrorsOfAPeriodicSource_CorrectsThem(double errorMs, double limit, double limitOfSwing)
    {
        var settings = Usual with { StampError = errorMs / 1000 };

        Assert.That(OverQuadratic(seed => Motions.FastMoves(seed), settings), Is.LessThan(limit), Message);
        Assert.That(OverQuadratic(_ => Motions.PaperSwing(30), settings), Is.LessThan(limitOfSwing), Message);
        Assert.That(Ratio(seed => Motions.FastMoves(seed), settings), Is.LessThan(1.2 * Ratio(seed => Motions.FastMoves(seed), Usual)), Message);
    }

    [Test]
    public void Adaptive_SamplingJitter_IsMoreAccurateThanTheQuadratic()
    {
        Assert.That(OverQuadratic(s => Motions.FastMoves(s), Usual with { SamplingJitter = 0.005 }), Is.LessThan(0.80), "not stamped, " + Message);
        Assert.That(OverQuadratic(s => Motions.FastMoves(s), Usual with { StampedJitter = 0.010 }), Is.LessThan(0.80), "stamped, " + Message);
    }

    [Test]
    public void Adaptive_LossAndReordering_IsMoreAccurateThanTheQuadratic() => Assert.That(
        OverQuadratic(s => Motions.FastMoves(s), Usual with { Latency = 0.06, DelayMedian = 0.012, Loss = 0.01 }), Is.LessThan(0.70), Message);

    // A cycle takes 3.5 to 5 s. The prediction must use the repetition from the fourth cycle on.
    [TestCase(20, 100)]
    [TestCase(50, 100)]
    public void Adaptive_RepeatingCycles_PredictsFromTheFourthCycle(double samplingMs, double latencyMs)
    {
        var settings = At(samplingMs, latencyMs) with { WarmUp = 15 };

        Assert.That(Ratio(s => Motions.Repeats(s, default), settings), Is.LessThan(0.05), "exact, " + Message);
        var mixed = new CycleVariation[] { new(0.01), new(0.05), new(0.2), new(0, 2), new(0, 20), new(0, 0, 0.03), new(0, 0, 0.1) };
        Assert.That(mixed.Average(variation => Ratio(s => Motions.Repeats(s, variation), settings)), Is.LessThan(0.17), "mixed, " + Message);
    }

    [TestCase(20, 100)]
    [TestCase(50, 100)]
    [TestCase(100, 150)]
    public void Adaptive_NonRepeatingMotion_TemplatesDoNotIncreaseTheError(double samplingMs, double latencyMs)
    {
        static JointPredictor WithoutTemplate() => Predictors.Adaptive(
            PredictionLimits.Unlimited, PredictionParts.Joint & ~PredictionParts.Repetition);
        foreach (var motionOf in new Func<int, AxisMotion>[] { s => Motions.FastMoves(s), s => Motions.GentleMoves(s), s => Motions.Waves(s) })
            Assert.That(
                Ratio(motionOf, At(samplingMs, latencyMs)) / Ratio(motionOf, At(samplingMs, latencyMs), WithoutTemplate),
                Is.LessThan(1.05), motionOf(1).Name + ", " + Message);
    }

    [TestCase(false, 0.60)]
    [TestCase(true, 0.50)]
    public void Adaptive_SamplesWithVelocity_UsesTheVelocity(bool tellsAcceleration, double limit) => Assert.That(
        OverQuadratic(s => Motions.FastMoves(s), Usual with { HasVelocity = true, HasAcceleration = tellsAcceleration }), Is.LessThan(limit), Message);

    [TestCase(50, 100, 0.45)]
    [TestCase(100, 150, 0.50)]
    public void Adaptive_KnownDriveLimits_ErrorIsBelowHalfOfTheQuadraticsError(double samplingMs, double latencyMs, double limit)
    {
        var limits = new PredictionLimits(
            horizonCap: double.PositiveInfinity, maximumGap: double.PositiveInfinity, velocity: 1000, acceleration: 5000, jerk: 50_000);
        double Of(Func<JointPredictor> newPredictor) => Ratio(Motions.MovesOfOneDrive, At(samplingMs, latencyMs), newPredictor);

        var share = Of(() => Predictors.Create("adaptive", limits)) / Of(() => Predictors.Create("quadratic", PredictionLimits.Unlimited));

        Assert.That(share, Is.LessThan(limit), Message);
    }

    [TestCase(20, 0.02)]
    [TestCase(20, 0.1)]
    [TestCase(50, 0.02)]
    [TestCase(50, 0.5)]
    public void Adaptive_NoiseAtStandstill_IsNotAmplified(double samplingMs, double noise)
    {
        var settings = At(samplingMs, 100) with { Noise = noise, WarmUp = 24 };
        static AxisMotion RestAfterMoves(int seed)
        {
            var moves = Motions.FastMoves(seed, 20);
            return new AxisMotion("rest after moves", 45, t => t < 20 ? moves.At(t) : moves.At(1e6));
        }

        var worst = Seeds.Max(seed => Rms(RestAfterMoves(seed), settings with { Seed = seed }, Adaptive) / noise);
        var quadratic = Seeds.Min(seed => Rms(RestAfterMoves(seed), settings with { Seed = seed }, () => Create("quadratic")) / noise);

        Assert.That(worst, Is.LessThan(15).And.LessThan(quadratic), Message);
    }

    static string Message => "seeds " + string.Join(", ", Seeds);

    static JointPredictor Create(string name) => Predictors.Create(name, PredictionLimits.Unlimited);

    static JointPredictor Adaptive() => Create("adaptive");

    static double Ratio(Func<int, AxisMotion> motionOf, StudySettings settings) => Ratio(motionOf, settings, Adaptive);

    static double Ratio(Func<int, AxisMotion> motionOf, StudySettings settings, Func<JointPredictor> newPredictor) =>
        Seeds.Average(seed =>
        {
            var errors = PredictionStudy.Run(motionOf(seed), settings with { Seed = seed }, newPredictor);
            return errors.Rms / errors.RmsHold;
        });

    static double OverQuadratic(Func<int, AxisMotion> motionOf, StudySettings settings) => OverBest(motionOf, settings, "quadratic");

    static double OverBest(Func<int, AxisMotion> motionOf, StudySettings settings) => OverBest(motionOf, settings, Fixed);

    static double OverBest(Func<int, AxisMotion> motionOf, StudySettings settings, params string[] names) => Seeds.Average(seed =>
        Rms(motionOf(seed), settings with { Seed = seed }, Adaptive)
        / names.Min(name => Rms(motionOf(seed), settings with { Seed = seed }, () => Create(name))));

    static double Rms(AxisMotion motion, StudySettings settings, Func<JointPredictor> newPredictor) =>
        PredictionStudy.Run(motion, settings, newPredictor).Rms;
}
