using System.Globalization;
using System.Text.Json;
using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public class SineVerbTests : CalibrationFolder
{
    async Task<JsonElement> Measured(Jog jog, params string[] options)
    {
        var run = await CliRun.OfAsync(["calibrate", "sine", Write("jog.csv", jog.Lines()), "--json", "--out", Out, .. options]);
        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        return JsonDocument.Parse(run.Output).RootElement;
    }

    [Test]
    public void Run_Cancelled_WritesNothing()
    {
        var parsed = SineVerb.Create().Parse([Write("jog.csv", new Jog(100).Lines()), "--out", Out]);

        Assert.That(() => SineVerb.RunAsync(parsed, new CancellationToken(canceled: true)), Throws.InstanceOf<OperationCanceledException>());
        Assert.That(Directory.Exists(Out), Is.False);
    }

    [Test]
    public async Task Sine_SlowJog_ErrsByLessThanThreeMilliseconds()
    {
        for (var seed = 1; seed <= 24; seed++)
        {
            var jog = new Jog(30 + 11.3 * seed)
            {
                Seed = seed, Period = 1.5 + seed % 4 * 0.7, Amplitude = new[] { 80, 150, 300 }[seed % 3], Seconds = 8 + seed % 5, Scale = seed % 2 == 0 ? 1 : 0.6,
            };

            var result = await Measured(jog);

            var error = result.GetProperty("total_ms").GetDouble() - jog.LagMs;
            Assert.That(Math.Abs(error), Is.LessThan(3), "seed " + seed);
            Assert.That(Math.Abs(error), Is.LessThan(4.5 * result.GetProperty("total_sd_ms").GetDouble() + 0.2), "seed " + seed);
        }
    }

    // The manual recommends 25 pictures per second. The lags are between two pictures, and near the middle between them.
    [TestCase(25, false)]
    [TestCase(25, true)]
    [TestCase(30, false)]
    [TestCase(30, true)]
    [TestCase(60, true)]
    public async Task Sine_LagBetweenPictures_IsNotBiased(double fps, bool isTriangle)
    {
        double[] lags = [5, 19, 21, 139, 141];
        foreach (var lag in lags)
        {
            var result = await Measured(new Jog(lag) { Fps = fps, IsTriangle = isTriangle, Noise = 0, Seconds = 12 });

            Assert.That(result.GetProperty("total_ms").GetDouble(), Is.EqualTo(lag).Within(0.1), $"lag {lag} ms");
        }
    }

    [Test]
    public async Task Sine_PicturesWithNoise_UncertaintyIsThatOfTheResults()
    {
        const int jogs = 40;
        var squares = 0.0;
        for (var seed = 1; seed <= jogs; seed++)
        {
            var jog = new Jog(97 + 1.1 * seed) { Seed = seed, Fps = 25, Period = 3, IsTriangle = seed % 2 == 0 };

            var result = await Measured(jog, "--exposure-ms", "0");

            var relative = (result.GetProperty("total_ms").GetDouble() - jog.LagMs) / result.GetProperty("total_sd_ms").GetDouble();
            squares += relative * relative;
        }
        Assert.That(Math.Sqrt(squares / jogs), Is.InRange(0.7, 1.3));
    }

    // A player that stretches slow-motion video eight times also stretches the lag and the period.
    [Test]
    public async Task Sine_AnyRecording_StatesThePeriodOfTheJog()
    {
        var result = await Measured(new Jog(12) { Period = 2.5, Seconds = 14 });

        Assert.That(result.GetProperty("period_s").GetDouble(), Is.EqualTo(2.5).Within(0.05));
        Assert.That(await File.ReadAllTextAsync(Path.Combine(Out, "calibration.html")), Does.Contain(SinePageTexts.Period(2.5)));
    }

    [Test]
    public async Task Sine_ReadOutTimeWithATable_Fails() => Assert.That(
        await RefusalOf("sine", Write("jog.csv", new Jog(90).Lines()), "--readout-ms", "20"),
        Is.EqualTo(ConsoleMessages.Line(SineMessages.ReadoutOfTable)));

    // The display is lit for 4 ms of each refresh, at the same moment of each exposure. The hologram is in time.
    static IEnumerable<string> Flashed(double fps, double phaseMs)
    {
        const double RefreshHz = 60, LitMs = 4;
        double Place(double ms) => 150 * Math.Sin(2 * Math.PI * ms / 2500);
        yield return "t_s,robot_px,hologram_px";
        for (var i = 0; i < 12 * fps; i++)
        {
            double middle = 1000 * i / fps + phaseMs, from = middle - 500 / fps, to = middle + 500 / fps, sum = 0, weight = 0;
            for (var flash = Math.Floor(from * RefreshHz / 1000) - 1; flash * 1000 / RefreshHz < to + LitMs; flash++)
            {
                var at = flash * 1000 / RefreshHz;
                var lit = Math.Max(0, Math.Min(to, at + LitMs / 2) - Math.Max(from, at - LitMs / 2));
                (sum, weight) = (sum + lit * Place(at), weight + lit);
            }
            yield return string.Create(CultureInfo.InvariantCulture, $"{i / fps:0.######},{Place(middle):0.###},{sum / weight:0.###}");
        }
    }

    [TestCase(60, 4)]
    [TestCase(60, 7)]
    [TestCase(30, 4)]
    [TestCase(25, 1)]
    public async Task Sine_CameraInStepWithTheDisplay_UncertaintyCoversTheError(double fps, double phaseMs)
    {
        var result = JsonDocument.Parse((await CliRun.OfAsync(
            "calibrate", "sine", Write("jog.csv", Flashed(fps, phaseMs)), "--visu-ms", "40", "--json", "--out", Out)).Output).RootElement;

        var (error, deviation) = (Math.Abs(result.GetProperty("visu_ms").GetDouble() - 40), result.GetProperty("total_sd_ms").GetDouble());
        Assert.That(error, Is.LessThanOrEqualTo(Math.Sqrt(3) * deviation));
        Assert.That(deviation, fps == 25 ? Is.LessThan(1.5) : Is.LessThan(5), "the bound is not wider than the exposure");
    }

    // The hologram is ahead of the robot, because the columns are in the wrong order; or it is later than any display.
    [TestCase("--columns=hologram_px,robot_px", "--app-ms=10")]
    [TestCase("--columns=robot_px,hologram_px", "--visu-ms=450")]
    public async Task Sine_ImplausibleVisu_IsRefusedWithTheFile(params string[] options)
    {
        var file = Write("jog.csv", new Jog(100).Lines());

        var run = await CliRun.OfAsync(["calibrate", "sine", file, .. options, "--out", Out]);

        Assert.That(run.ExitStatus, Is.EqualTo(2), run.Errors);
        Assert.That(run.Errors, Does.StartWith($"nowpose: {file}: "));
        Assert.That(File.Exists(ProfilePath), Is.False);
    }

    [Test]
    public async Task Sine_ShortExposure_HasASmallUncertainty() =>
        Assert.That((await Measured(new Jog(12), "--visu-ms", "30", "--exposure-ms", "2")).GetProperty("total_sd_ms").GetDouble(), Is.LessThan(1));

    // The error is up to half the interval between pictures, 8.3 ms, with an unknown sign. The exposure is short.
    [TestCase(50, 8.3)]
    [TestCase(41.667, 4.2)]
    [TestCase(47, 0)]
    public async Task Sine_SamplesSynchronousWithPictures_StatesTheUncertainty(double samplingMs, double mayBeOff)
    {
        for (var seed = 1; seed <= 8; seed++)
        {
            var jog = new Jog(95 + samplingMs / 2) { SamplingMs = samplingMs, Seed = seed };
            var sampling = samplingMs.ToString(CultureInfo.InvariantCulture);
            var run = await CliRun.OfAsync(
                "calibrate", "sine", Write("jog.csv", jog.Lines()), "--app-ms", "60", "--sampling-ms", sampling, "--exposure-ms", "0",
                "--json", "--out", Out);

            Assert.That(run.ExitStatus, Is.Zero, run.Errors);
            var result = JsonDocument.Parse(run.Output).RootElement;
            var error = result.GetProperty("visu_ms").GetDouble() - (jog.LagMs - 60);
            Assert.That(Math.Abs(error), Is.LessThan(3 + mayBeOff), $"seed {seed}");
            Assert.That(run.Errors.Contains(SineMessages.SteppedGhost(null, 0).Split(" ms,")[0]), Is.EqualTo(mayBeOff > 0), run.Errors);
            if (mayBeOff > 0)
                Assert.That(result.GetProperty("total_sd_ms").GetDouble(), Is.InRange(mayBeOff / Math.Sqrt(3), mayBeOff), run.Errors);
        }
    }

    [Test]
    public async Task Sine_UncompensatedGhost_SubtractsTheDelayOfTheSamples()
    {
        // The lag consists of 60 ms until a sample arrives, up to 47 ms until the next sample replaces it, and 40 ms for the display.
        var result = await Measured(new Jog(100) { SamplingMs = 47, Seconds = 12 }, "--app-ms", "60", "--sampling-ms", "47");

        Assert.That(result.GetProperty("visu_ms").GetDouble(), Is.EqualTo(40).Within(3));
        var profile = LatencyProfileFile.Load(ProfilePath);
        Assert.That(profile.Visualisation.Length.TotalMilliseconds, Is.EqualTo(result.GetProperty("visu_ms").GetDouble()).Within(1e-3));
        Assert.That(profile.Method, Is.EqualTo(CalibrationMethod.Sine));
    }

    [Test]
    public async Task Sine_CompensatedGripper_AddsTheMeasuredLagToTheUsedLVisu()
    {
        var result = await Measured(new Jog(12), "--visu-ms", "30");

        Assert.That(result.GetProperty("visu_ms").GetDouble(), Is.EqualTo(42).Within(2));
    }

    [Test]
    public async Task Sine_OldNameOfVisuMs_IsAccepted()
    {
        var result = await Measured(new Jog(12), "--told-ms", "30");

        Assert.That(result.GetProperty("visu_ms").GetDouble(), Is.EqualTo(42).Within(2));
    }

    [Test]
    public async Task Sine_EarlierProfile_KeepsItsLimit()
    {
        var earlier = Path.Combine(Folder, "earlier.json");
        LatencyProfileFile.Save(earlier, new LatencyProfile(
            40, 1, "HoloLens 2", 60, DateTime.UnixEpoch, CalibrationMethod.VisibleLight, 9, 15.1, RenderTimeSourceKind.GpuCompletion));

        await Measured(new Jog(12), "--visu-ms", "30", "--profile", earlier);

        var profile = LatencyProfileFile.Load(ProfilePath);
        Assert.That(profile.Range.Limit.TotalMilliseconds, Is.EqualTo(15.1).Within(1e-3));
        Assert.That((profile.Device, profile.DisplayHz), Is.EqualTo(("HoloLens 2", 60)));
        Assert.That(await RefusalOf("sine", Write("jog.csv", new Jog(12).Lines()), "--visu-ms", "30", "--profile", earlier, "--device", "Quest 3"),
            Does.Contain("'HoloLens 2'").And.Contain("'Quest 3'"));
    }

    [Test]
    public async Task Sine_NoLatencyOption_ReportsTheTotalLatencyOnly()
    {
        var result = await Measured(new Jog(120));

        Assert.That(result.GetProperty("visu_ms").ValueKind, Is.EqualTo(JsonValueKind.Null));
        Assert.That(File.Exists(ProfilePath), Is.False);
        Assert.That(File.Exists(Path.Combine(Out, "calibration.html")), Is.True);
    }

    [Test]
    public async Task Sine_RobotPositionsFromTheControlSystem_GiveTheSameResult()
    {
        var both = new Jog(90).Lines().Skip(1).Select(line => line.Split(',')).ToArray();
        var control = Write("control.csv", both.Select(row => $"{row[0]},{row[1]},0").Prepend("t,axis_1,axis_2"));
        var camera = Write("camera.csv", both.Skip(30).Select(row => $"{row[0]},{row[2]}").Prepend("t_s,x"));

        var run = await CliRun.OfAsync("calibrate", "sine", camera, "--control", control, "--joint", "axis_1", "--json", "--out", Out);

        Assert.That(JsonDocument.Parse(run.Output).RootElement.GetProperty("total_ms").GetDouble(), Is.EqualTo(90).Within(2));
    }

    [Test]
    public async Task Sine_InvertedPosition_RequiresTheOption()
    {
        var jog = new Jog(90) { Scale = -1 };

        Assert.That(await RefusalOf("sine", Write("jog.csv", jog.Lines())), Does.Contain("--inverted"));
        Assert.That((await Measured(jog, "--inverted")).GetProperty("total_ms").GetDouble(), Is.EqualTo(90).Within(2));
    }

    [Test]
    public async Task Sine_JogTooFast_FailsAsAmbiguous() =>
        Assert.That(await RefusalOf("sine", Write("jog.csv", new Jog(90) { Period = 0.3 }.Lines())),
            Does.EndWith("jog.csv: " + SineMessages.Ambiguous(0.3)));

    [Test]
    public async Task Sine_TimeStampsInMilliseconds_NamesTheInterval()
    {
        var rows = new Jog(90).Lines().Skip(1).Select((line, i) => string.Create(CultureInfo.InvariantCulture, $"{10 * i},") + line.Split(',', 2)[1]);

        Assert.That(await RefusalOf("sine", Write("jog.csv", rows.Prepend("t,robot,hologram")), "--visu-ms", "40"),
            Does.EndWith("jog.csv: " + SineMessages.IntervalTooLong(10, 0.6)));
    }

    [Test]
    public async Task Sine_SameColumnTwice_IsRefused() =>
        Assert.That(
            await RefusalOf("sine", Write("jog.csv", new Jog(90).Lines()), "--columns", "robot_px,robot_px", "--visu-ms", "40"),
            Is.EqualTo(ConsoleMessages.Line(SineMessages.SameColumn("robot_px"))));

    [TestCase("t_s,a,b\n0,1,2\n1,1,2", "at least 60")]
    [TestCase("t_s,a,b,c\n0,1,2,3\n1,2,3,4", "--columns ROBOT,HOLOGRAM")]
    [TestCase("t_s,a,b\n0,1,2\n1,NaN,2", ":3: field 'a': 'NaN' is not a finite number")]
    public async Task Sine_InvalidRecording_StatesTheRequirement(string text, string named) =>
        Assert.That(await RefusalOf("sine", Write("jog.csv", [text])), Does.Contain(named));

    [Test]
    public async Task Sine_RobotAtRest_ReportsThatTheRobotDoesNotMove()
    {
        var rest = Enumerable.Range(0, 600).Select(i => string.Create(CultureInfo.InvariantCulture, $"{i / 60.0:0.####},640,{i % 7}"));

        Assert.That(await RefusalOf("sine", Write("jog.csv", rest.Prepend("t,robot,hologram"))),
            Does.EndWith("jog.csv: " + SineMessages.NoMotion("the robot")));
    }

    [Test]
    public async Task Sine_OptionsForBothMethods_Fails() =>
        Assert.That(
            await RefusalOf("sine", Write("jog.csv", new Jog(90).Lines()), "--app-ms", "60", "--visu-ms", "40"),
                Is.EqualTo(ConsoleMessages.Line(SineMessages.BothWays)));
}
