using Nowpose.Cli.Messages;
using Nowpose.Cli.Replay;
using Nowpose.Gateway.MotionRecordings;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Replay;

public class ReplayRunTests
{
    static readonly Func<double, double>[] Joints =
    [
        t => Math.Sin(2.1 * t) + 0.2 * Math.Sin(9 * t),
        t => 0.3 * Math.Cos(4 * t) - t * 0.1,
        t => t < 2 ? 1 : 1 + 0.4 * (1 - Math.Cos(3 * (t - 2)))
    ];

    string _folder;

    [SetUp]
    public void CreateFolder() => _folder = Directory.CreateTempSubdirectory("nowpose-replay-").FullName;

    [TearDown]
    public void DeleteFolder() => Directory.Delete(_folder, recursive: true);

    ReplayResult Replay(MotionFile motion, ReplaySettings settings)
    {
        var path = motion.WriteTo(_folder);
        return new ReplayRun(path, MotionRecording.Read(path), settings).Run();
    }

    static MotionFile Ramp(decimal duration) => new(0, MotionFile.EvenTimes(duration, 0.01m), t => t);

    static readonly object[] Conditions =
    [
        // Columns: sampling (ms), latency (ms), frames per second, predictor, degree, history, latency error (ms).
        new object[] { 50m, 100m, 60m, "hold", 0, 0, 0m },
        new object[] { 50m, 100m, 60m, "linear", 1, 1, 0m },
        new object[] { 50m, 100m, 60m, "quadratic", 2, 2, 0m },
        new object[] { 50m, 100m, 60m, "cubic", 3, 3, 0m },
        new object[] { 50m, 100m, 60m, "quadratic-h3", 2, 3, 0m },
        new object[] { 50m, 100m, 60m, "quadratic-h4", 2, 4, 0m },
        new object[] { 20m, 100m, 60m, "cubic", 3, 3, 0m },
        new object[] { 100m, 150m, 60m, "quadratic-h4", 2, 4, 0m },
        new object[] { 50m, 0m, 60m, "quadratic", 2, 2, 0m },
        new object[] { 50m, 100m, 60m, "quadratic", 2, 2, 20m },
        new object[] { 50m, 100m, 60m, "quadratic", 2, 2, -50m },
        new object[] { 20m, 20m, 60m, "linear", 1, 1, -150m },
        new object[] { 33.3m, 66.7m, 90m, "quadratic-h3", 2, 3, 0m },
        new object[] { 41.7m, 83.25m, 59.94m, "linear", 1, 1, 7.5m },
        new object[] { 16.6666666m, 33.3333333m, 60m, "quadratic", 2, 2, 0m },
        new object[] { 500m, 400m, 60m, "linear", 1, 1, 0m },
        new object[] { 7m, 300m, 30m, "quadratic-h4", 2, 4, 0m }
    ];

    [TestCaseSource(nameof(Conditions))]
    public void Run_UnevenTimesFarFromZero_AgreesWithTheReference(
        decimal samplingMs, decimal latencyMs, decimal fps, string predictor, int degree, int history, decimal latencyErrorMs)
    {
        var motion = new MotionFile(1234.567891m, MotionFile.UnevenTimes(6, seed: 3), Joints);

        AssertAgrees(motion, samplingMs, latencyMs, fps, predictor, degree, history, latencyErrorMs);
    }

    // The recording ends at a frame and a sample, between two frames, within a rounding error of a frame, or about half a tick from a frame.
    [TestCase("5")]
    [TestCase("4.99")]
    [TestCase("4.9999999")]
    [TestCase("5.0000001")]
    [TestCase("4.98333333")]
    [TestCase("4.98333336")]
    [TestCase("4.98333324")]
    public void Run_EndNearAFrame_RoundsToTheNearestTick(string duration)
    {
        var end = decimal.Parse(duration, System.Globalization.CultureInfo.InvariantCulture);
        var motion = new MotionFile(-2.5m, MotionFile.UnevenTimes(end, seed: 4), Joints);

        AssertAgrees(motion, 50, 100, 60, "quadratic", 2, 2, 0);
    }

    [Test]
    public void Run_StampsSince1970_KeepsThePrecision()
    {
        // Binary fractions, which a double represents exactly even at 1.7e9 s.
        var motion = new MotionFile(1700000000.25m, MotionFile.EvenTimes(5, 0.0078125m), Joints);

        AssertAgrees(motion, 50, 100, 60, "cubic", 3, 3, 0);
    }

    void AssertAgrees(MotionFile motion, decimal samplingMs, decimal latencyMs, decimal fps, string predictor,
        int degree, int history, decimal latencyErrorMs)
    {
        var expected = new ReplayReference(motion, samplingMs, latencyMs, fps, degree, history, latencyErrorMs);

        var result = Replay(motion, new ReplaySettings
        {
            SamplingInterval = (double)samplingMs / 1000, Latency = (double)latencyMs / 1000, FrameRateHz = (double)fps,
            Predictor = predictor, LatencyError = (double)latencyErrorMs / 1000
        });

        Assert.That(result.Frames, Is.EqualTo(expected.Frames), "frames");
        double sumHold = 0, sum = 0;
        for (var joint = 0; joint < motion.Joints; joint++)
        {
            var axis = result.Axes[joint];
            Assert.That(axis.Name, Is.EqualTo("q" + (joint + 1)));
            AssertSame(axis.Error.RmsHold, expected.RmsHold(joint), axis.Name + " rms_hold");
            AssertSame(axis.Error.Rms, expected.Rms(joint), axis.Name + " rms");
            AssertSame(axis.Error.P95, expected.P95(joint), axis.Name + " p95");
            AssertSame(axis.Error.Max, expected.Max(joint), axis.Name + " max");
            sumHold += expected.RmsHold(joint) * expected.RmsHold(joint);
            sum += expected.Rms(joint) * expected.Rms(joint);
        }
        AssertSame(result.RmsHold, Math.Sqrt(sumHold), "rms_hold");
        AssertSame(result.Rms, Math.Sqrt(sum), "rms");
        AssertSame(result.Reduction.Value, 1 - Math.Sqrt(sum / sumHold), "reduction");
    }

    static void AssertSame(double value, double expected, string what)
    {
        // The times in the file are doubles. At 1235 s, their error is 2e-13 s, which a cubic amplifies.
        Assert.That(value, Is.EqualTo(expected).Within(1e-8 * Math.Abs(expected) + 1e-14), what);
    }

    [Test]
    public void Run_RobotAtRest_HasNoReduction()
    {
        var result = Replay(new MotionFile(0, MotionFile.EvenTimes(3, 0.1m), _ => 0.7), new ReplaySettings());

        Assert.That(result.RmsHold, Is.EqualTo(0));
        Assert.That(result.Rms, Is.EqualTo(0));
        Assert.That(result.Reduction, Is.Null);
    }

    [TestCase(0.02, 0)]
    [TestCase(0.2, 0)]
    [TestCase(0, 0.4)]
    [TestCase(0.2, 0.4)]
    public void Run_RampWithLateAndLostSamples_LineIsExact(double jitter, double loss)
    {
        // Each t_k is known exactly, so late and lost samples change only the horizon.
        var result = Replay(Ramp(20), new ReplaySettings { Predictor = "linear", Jitter = jitter, Loss = loss });

        Assert.That(result.Rms, Is.LessThan(1e-12));
        Assert.That(result.RmsHold, Is.GreaterThan(0.118));
    }

    [Test]
    public void Run_LostSamples_HoldErrorMatchesAGeometricNumberOfLosses()
    {
        const double p = 0.3, interval = 0.05;

        var result = Replay(Ramp(300), new ReplaySettings { Loss = p });

        // Frames show a sample 0, 1/60 and 2/60 s after its arrival. For G consecutive losses, E G = p/(1-p) and E G² = p (1+p)/(1-p)².
        var square = Enumerable.Range(0, 3).Select(n => 0.1 + n / 60.0).Average(age =>
            age * age + 2 * age * interval * p / (1 - p) + interval * interval * p * (1 + p) / ((1 - p) * (1 - p)));
        Assert.That(result.RmsHold, Is.EqualTo(Math.Sqrt(square)).Within(0.02 * Math.Sqrt(square)));
    }

    [Test]
    public void Run_SeveralPhases_FramesHaveAllAgesOfTheNewestSample()
    {
        ReplayResult Of(int phases) => Replay(Ramp(60), new ReplaySettings { Predictor = "hold", Phases = phases });

        // With one phase, three frames are 0, 1/60 and 2/60 s later than the newest sample, which is 0.1 s old on arrival.
        static double Rms(int ages, double step) => Math.Sqrt(Enumerable.Range(0, ages).Average(n => Math.Pow(0.1 + n * step, 2)));
        Assert.That(Of(1).RmsHold, Is.EqualTo(Rms(3, 1 / 60.0)).Within(1e-4));
        Assert.That(Of(10).RmsHold, Is.EqualTo(Rms(30, 1 / 600.0)).Within(1e-4));
        Assert.That(Of(10).Frames, Is.EqualTo(10 * Of(1).Frames).Within(10));
    }

    [Test]
    public void Run_RampWithStampErrors_LineAmplifiesTheErrorsByItsGain()
    {
        const double halfWidth = 0.001;

        var exact = Replay(Ramp(300), new ReplaySettings { Predictor = "linear" });
        var result = Replay(Ramp(300), new ReplaySettings { Predictor = "linear", StampError = halfWidth });

        // First order: e0 (1 + x) - e1 x with x = horizon / T_s = 2, 7/3, 8/3. Each error has the variance halfWidth²/3.
        var gain = new[] { 2, 7 / 3.0, 8 / 3.0 }.Average(x => (1 + x) * (1 + x) + x * x);
        var expected = halfWidth * Math.Sqrt(gain / 3);
        Assert.That(result.Rms, Is.EqualTo(expected).Within(0.03 * expected));
        Assert.That(result.RmsHold, Is.EqualTo(exact.RmsHold), "the uncompensated pose does not depend on the stamps");
    }

    [Test]
    public void Run_StampErrorsAboveTheInterval_HoldErrorIsUnchanged()
    {
        var exact = Replay(Ramp(20), new ReplaySettings { SamplingInterval = 0.01 });

        var result = Replay(Ramp(20), new ReplaySettings { SamplingInterval = 0.01, StampError = 0.03 });

        Assert.That(result.RmsHold, Is.EqualTo(exact.RmsHold));
    }

    [Test]
    public void Run_Jitter_HoldErrorIsBetweenThoseOfMinimumAndMaximumDelay()
    {
        var exact = Replay(Ramp(60), new ReplaySettings());
        var latest = Replay(Ramp(60), new ReplaySettings { Latency = 0.13 });

        var result = Replay(Ramp(60), new ReplaySettings { Jitter = 0.03 });

        Assert.That(result.RmsHold, Is.GreaterThan(exact.RmsHold + 0.005).And.LessThan(latest.RmsHold - 0.005));
    }

    [Test]
    public void Run_Seed_DeterminesTheResult()
    {
        ReplaySettings Seeded(int seed) => new() { Jitter = 0.05, Loss = 0.1, StampError = 0.005, Seed = seed };

        var first = Replay(Ramp(10), Seeded(5)).Rms;

        Assert.That(Replay(Ramp(10), Seeded(5)).Rms, Is.EqualTo(first));
        Assert.That(Replay(Ramp(10), Seeded(6)).Rms, Is.Not.EqualTo(first));
    }

    [TestCase("0.3", 1)]
    [TestCase("0.29", 0)]
    public void Run_EndsNearTheFourthSample_ScoresAtMostOneFrame(string duration, int frames)
    {
        var motion = Ramp(decimal.Parse(duration, System.Globalization.CultureInfo.InvariantCulture));

        if (frames > 0) Assert.That(Replay(motion, new ReplaySettings()).Frames, Is.EqualTo(frames));
        else Assert.That(() => Replay(motion, new ReplaySettings()),
            Throws.InstanceOf<InputException>().With.Message.EndsWith(": " + ReplayMessages.TooShort(0.29, 4 * 0.05 + 0.1 + 1 / 60.0)));
    }

    [Test]
    public void Run_TimesInMilliseconds_Throws()
    {
        var motion = new MotionFile(0, [0m, 4_000_000m, 20_000_000m], t => t);

        Assert.That(() => Replay(motion, new ReplaySettings()),
            Throws.InstanceOf<InputException>().With.Message.EndsWith(ReplayMessages.TooManyFrames("", 20_000_000, 60, 50)));
    }

    [TestCase(1e155)]
    [TestCase(1e200)]
    [TestCase(1e300)]
    public void Run_PositionsOfOneAxisTooLargeToSquare_NamesTheAxis(double size)
    {
        var motion = new MotionFile(0, MotionFile.EvenTimes(2, 0.1m), t => t, t => size * Math.Sin(9 * t), t => 2 * t);

        Assert.That(() => Replay(motion, new ReplaySettings()),
            Throws.InstanceOf<InputException>().With.Message.EndsWith(ReplayMessages.TooLarge("", "q2")));
    }

    [Test]
    public void Run_LongRecording_ReportsTheFinishedFrames()
    {
        var path = Ramp(40).WriteTo(_folder);
        var run = new ReplayRun(path, MotionRecording.Read(path), new ReplaySettings());
        var reported = new List<int>();

        run.Run(report: reported.Add);

        Assert.That(run.Frames, Is.EqualTo(2401));
        Assert.That(reported, Is.EqualTo(new[] { 0, 1000, 2000 }));
    }
}
