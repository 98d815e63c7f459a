using Nowpose.Cli.Studies;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Prediction;

/// <summary>
/// Tests whether the errors of <c>gp</c> agree with its standard deviation on motions that were not used for tuning. The time constant was
/// chosen with seeds 101 to 103; the tests use 9001 to 9003. In a normal distribution, 68 % and 95 % are within one and two deviations.
/// </summary>
public class DeviationCalibrationTests
{
    static readonly int[] Seeds = [9001, 9002, 9003];

    public static IEnumerable<TestCaseData> Cases() =>
        from condition in new[] { (20.0, 100.0), (50, 100), (100, 150) }
        from motion in new (string Name, Func<int, AxisMotion> Of)[]
        {
            ("fast", seed => Motions.FastMoves(seed)), ("gentle", seed => Motions.GentleMoves(seed)), ("soft", seed => Motions.SoftMoves(seed)),
            ("waves", seed => Motions.Waves(seed)), ("swing", _ => Motions.PaperSwing(30)),
        }
        select new TestCaseData(condition.Item1, condition.Item2, motion.Of).SetName($"{{m}}({motion.Name},{condition.Item1},{condition.Item2})");

    [TestCaseSource(nameof(Cases))]
    public void Deviation_SimulatedMotions_MatchesTheErrors(double samplingMs, double latencyMs, Func<int, AxisMotion> motionOf)
    {
        var settings = new StudySettings { SamplingInterval = samplingMs / 1000, Latency = latencyMs / 1000 };
        double frames = 0, insideOne = 0, insideTwo = 0, squares = 0, variances = 0;
        foreach (var seed in Seeds)
            for (var phase = 0; phase < 2; phase++)
            {
                var predictor = Predictors.Create("gp", PredictionLimits.Unlimited);
                foreach (var frame in PredictionStudy.Frames(motionOf(seed), settings with { Seed = seed }, predictor, phase))
                {
                    var (error, deviation) = (Math.Abs(frame.Predicted - frame.Truth), predictor.DeviationAt(frame.Time));
                    frames++;
                    if (error <= deviation) insideOne++;
                    if (error <= 2 * deviation) insideTwo++;
                    squares += error * error;
                    variances += deviation * deviation;
                }
            }

        var stated = Math.Sqrt(variances / squares);
        var message = $"{insideOne / frames:P1} inside one, {insideTwo / frames:P1} inside two, {stated:F2} of the RMS error stated, seeds {string.Join(", ", Seeds)}";
        TestContext.Out.WriteLine(message);
        Assert.That(stated, Is.InRange(0.85, 1.15), message);
        Assert.That(insideTwo / frames, Is.InRange(0.89, 0.98), message);
        // For moves and rests, the errors are not normally distributed: there are more small and more large ones.
        Assert.That(insideOne / frames, Is.InRange(0.50, 0.82), message);
    }

    // The scale is a mean over rest and motion, so it is too small after a long rest.
    [TestCase(20, 100)]
    [TestCase(50, 100)]
    [TestCase(100, 150)]
    public void Deviation_MovesAfterLongRests_CoversFewerFramesOfTheMoves(double samplingMs, double latencyMs)
    {
        const double minMovingMm = 1;
        var settings = new StudySettings { SamplingInterval = samplingMs / 1000, Latency = latencyMs / 1000 };
        var (frames, inside, moving, insideMoving) = (0.0, 0, 0.0, 0);
        foreach (var seed in Seeds)
            for (var phase = 0; phase < 2; phase++)
            {
                var predictor = Predictors.Create("gp", PredictionLimits.Unlimited);
                foreach (var frame in PredictionStudy.Frames(MovesAfterLongRests(seed), settings with { Seed = seed }, predictor, phase))
                {
                    var isInside = Math.Abs(frame.Predicted - frame.Truth) <= 2 * predictor.DeviationAt(frame.Time);
                    frames++;
                    if (isInside) inside++;
                    if (Math.Abs(frame.Held - frame.Truth) <= minMovingMm) continue;
                    moving++;
                    if (isInside) insideMoving++;
                }
            }

        var message = $"within two deviations: {inside / frames:P1} of all frames, {insideMoving / moving:P1} of the {moving / frames:P1} that move, "
            + $"seeds {string.Join(", ", Seeds)}";
        TestContext.Out.WriteLine(message);
        Assert.That(inside / frames, Is.InRange(0.90, 0.97), message);
        Assert.That(insideMoving / moving, Is.InRange(0.45, 0.70), message);
    }

    static AxisMotion MovesAfterLongRests(int seed)
    {
        var random = new Random(seed);
        double Between(double low, double high) => low + (high - low) * random.NextDouble();
        var sequence = new MoveSequence();
        while (sequence.Seconds < 120)
        {
            sequence.Dwell(Between(3, 6));
            sequence.MoveTo(-Math.Sign(sequence.End - 0.5) * Between(30, 500), Between(400, 1500), Between(3000, 10_000), Between(30_000, 100_000));
        }
        return sequence.Motion("moves after long rests");
    }
}
