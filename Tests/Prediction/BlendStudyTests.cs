using Nowpose.Cli;
using Nowpose.Cli.Studies;
using Nowpose.Prediction;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Prediction;

/// <summary>Tests the error that the blend adds and how it reduces jumps. The blend was tuned with seed 1; the tests use other seeds.</summary>
public class BlendStudyTests
{
    const double Blend = PredictionSettings.DefaultBlendMs / 1000;

    static IEnumerable<TestCaseData> Cases() =>
        from name in Predictors.Names
        where name != "hold"
        from timing in new[] { (SamplingMs: 20.0, LatencyMs: 100.0), (50, 100), (100, 150) }
        select new TestCaseData(name, timing.SamplingMs, timing.LatencyMs);

    static IEnumerable<AxisMotion> MotionsOf(int seed) =>
    [
        Motions.PaperSwing(), Motions.FastMoves(seed, 20), Motions.GentleMoves(seed, 30), Motions.SoftMoves(seed, 30),
        Motions.Trapezoids(seed, 20), Motions.EmergencyStops(seed, 30), Motions.Waves(seed, 20),
    ];

    [TestCaseSource(nameof(Cases))]
    public void Blend_MotionsNotUsedForTuning_ReducesJumpsWithASmallErrorIncrease(string predictor, double samplingMs, double latencyMs)
    {
        const int seed = 211;
        var settings = new StudySettings { SamplingInterval = samplingMs / 1000, Latency = latencyMs / 1000, Phases = 2, Seed = seed };
        var (rms, p95, max, count) = (0.0, 0.0, 0.0, 0);
        foreach (var motion in MotionsOf(seed))
        {
            var bare = Displayed.Of(motion, settings, () => Predictors.Create(predictor, PredictionLimits.Unlimited));
            var blended = Displayed.Of(motion, settings, () => Predictors.Create(predictor, PredictionLimits.Unlimited, Blend));
            Assert.That(blended.Error.Rms / bare.Error.Rms, Is.LessThan(1.05), $"{motion.Name}, seed {seed}");
            rms += Math.Log(blended.Error.Rms / bare.Error.Rms);
            p95 += Math.Log(blended.Jump.P95 / bare.Jump.P95);
            max += Math.Log(blended.Jump.Max / bare.Jump.Max);
            count++;
        }
        (rms, p95, max) = (Math.Exp(rms / count), Math.Exp(p95 / count), Math.Exp(max / count));
        TestContext.Out.WriteLine($"{predictor} {samplingMs}/{latencyMs}: RMS × {rms:0.000}, jump P95 × {p95:0.00}, greatest × {max:0.00}");

        Assert.That(rms, Is.LessThan(1.04));
        // At 20 ms, nearly every frame has its own section, so jumps can hardly be distinguished from motion.
        Assert.That(p95, Is.LessThan(samplingMs > 20 ? 0.92 : 1.005));
        Assert.That(max, Is.LessThan(samplingMs > 20 ? 0.88 : 1.005));
    }

    /// <summary>Errors of the displayed joint, and the amounts by which its motion per frame exceeds the true motion.</summary>
    sealed record Displayed(ErrorComparison Error, ErrorComparison Jump)
    {
        public static Displayed Of(AxisMotion motion, StudySettings settings, Func<JointPredictor> newPredictor)
        {
            var (errors, jumps) = (new ErrorCollector(), new ErrorCollector());
            for (var phase = 0; phase < settings.Phases; phase++)
            {
                var last = double.NaN;
                foreach (var frame in PredictionStudy.Frames(motion, settings, newPredictor(), phase))
                {
                    var error = frame.Predicted - frame.Truth;
                    errors.Add(0, error);
                    if (!double.IsNaN(last)) jumps.Add(0, error - last);
                    last = error;
                }
            }
            return new Displayed(errors.Result(), jumps.Result());
        }
    }
}
