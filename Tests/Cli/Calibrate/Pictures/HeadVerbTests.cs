using System.Text.Json;
using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Simulate;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;
using Nowpose.Vision;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate.Pictures;

/// <summary>
/// Tests the command <c>calibrate head</c>: from rendered pictures of a moving headset to readings, and from readings to a profile. HeadResultTests
/// covers the estimation. Needs Node.js, as the build does.
/// </summary>
public sealed class HeadVerbTests : CalibrationFolder
{
    string SavedProfile()
    {
        var path = Path.Combine(Folder, "still.json");
        LatencyProfileFile.Save(path, new LatencyProfile(
            41.8, 1.2, new DisplayConditions("HoloLens 2", 60, "Direct3D11"), new DateTime(2026, 11, 20, 0, 0, 0, DateTimeKind.Utc),
            CalibrationMethod.VisibleLight, 300, 15, RenderTimeSourceKind.DisplayGpuTime));
        return path;
    }

    // Uses a headset with late-stage reprojection. A reading error that is proportional to the speed would appear as a latency.
    [Test]
    public void Head_RenderedPictures_AreReadWithoutAnErrorThatDependsOnTheSpeed()
    {
        var settings = new SimulationSettings { Pictures = 24, PicturesPerPlace = 24, VisuMs = 42, HeadLatencyMs = 2, LoadSteps = 0, Seed = 5 };
        var sweep = new SimulatedSweep(settings);
        var camera = new SimulatedCamera(settings, sweep);
        Shot[] shots = [.. Enumerable.Range(0, settings.Pictures).Select(i => camera.Take(i, out _))];

        var result = new VlcRun(new PictureReader(0, 0)).Run(
            shots.Select(PictureRequest.Made), shots.Length, place => $"{place}", CancellationToken.None);

        Assert.That(result.Read, Has.Count.GreaterThanOrEqualTo(18));
        var (speeds, errors) = (new List<double>(), new List<double>());
        foreach (var picture in result.Read)
        {
            var place = int.Parse(picture.File);
            var moment = sweep.Moments[place];
            Assert.That(picture.VisuMs, Is.EqualTo(sweep.VisuMsOf(moment)).Within(1.5), "picture " + place);
            var codes = shots[place].Codes;
            speeds.Add(HeadSwing.SpeedAt(moment.Middle).X / 1000);
            errors.Add(picture.Places.Headset.X - MiddleOf(codes[1]) - (picture.Places.Control.X - MiddleOf(codes[0])));
        }
        Assert.That(SlopeOf(errors, speeds), Is.EqualTo(0).Within(1), "ms");
    }

    [Test]
    public async Task Head_ReadingsOfAMovingHeadset_AddsTheLatencyToTheProfile()
    {
        var picture = Write("picture.png", []);
        var parsed = HeadVerb.Create().Parse([picture, "--profile", SavedProfile(), "--reprojection", "depth", "--out", Out, "--json"]);
        var readings = new VlcResult(new SwungPictures { LatencyMs = 2, VisuMs = 42 }.Take());

        var run = await CapturedConsole.OfAsync(() => HeadVerb.RunAsync(parsed, _ => readings, CancellationToken.None));

        Assert.That(run.Status, Is.EqualTo(0), run.Errors);
        using var json = JsonDocument.Parse(run.Output);
        double Number(string name) => json.RootElement.GetProperty(name).GetDouble();
        Assert.That(Number("head_latency_ms"), Is.EqualTo(2).Within(0.5), run.Output);
        Assert.That(Number("head_latency_uncertainty_ms"), Is.GreaterThan(0).And.LessThan(1));
        Assert.That(Number("visu_ms"), Is.EqualTo(42).Within(0.5));
        var profile = LatencyProfileFile.Load(ProfilePath);
        Assert.That(profile.HeadMotion.Latency.TotalMilliseconds, Is.EqualTo(Number("head_latency_ms")).Within(0.001));
        Assert.That(profile.Conditions, Is.EqualTo(new DisplayConditions("HoloLens 2", 60, "Direct3D11", reprojection: ReprojectionMode.Depth)));
        Assert.That(profile.Visualisation.Length.TotalMilliseconds, Is.EqualTo(41.8), "L_visu is that of the still pictures");
        Assert.That(profile.Range.Limit.TotalMilliseconds, Is.EqualTo(15));
        Assert.That(profile.Measurements, Is.EqualTo(300));
    }

    [Test]
    public async Task Head_Interrupted_KeepsTheProfileAndWarns()
    {
        Directory.CreateDirectory(Out);
        await File.WriteAllTextAsync(ProfilePath, "earlier");
        var parsed = HeadVerb.Create().Parse([Write("picture.png", []), "--profile", SavedProfile(), "--out", Out]);
        var readings = new VlcResult(new SwungPictures { LatencyMs = 2, VisuMs = 42 }.Take());
        using var ctrlC = new CancellationTokenSource();

        var run = await CapturedConsole.OfAsync(() => HeadVerb.RunAsync(parsed, _ => Interrupted(), ctrlC.Token));

        Assert.That(await File.ReadAllTextAsync(ProfilePath), Is.EqualTo("earlier"));
        Assert.That(LatencyProfileFile.Load(Path.Combine(Out, "profile-interrupted.json")).HeadMotion, Is.Not.Null);
        Assert.That(run.Errors, Does.Contain(CalibrationMessages.Interrupted));
        Assert.That(await File.ReadAllTextAsync(Path.Combine(Out, "calibration.html")), Does.Contain(CalibrationMessages.Interrupted));

        VlcResult Interrupted()
        {
            ctrlC.Cancel();
            return readings;
        }
    }

    [Test]
    public async Task Head_TooFewPictures_AreRejected()
    {
        var folder = Path.Combine(Folder, "few");
        var simulated = await CliRun.OfAsync("calibrate", "simulate", "--pictures", "2", "--head-latency-ms", "2", "--seed", "5", "--out", folder);
        Assert.That(simulated.ExitStatus, Is.EqualTo(0), simulated.Errors);

        var head = await CliRun.OfAsync("calibrate", "head", Path.Combine(folder, "pictures"), "--out", Out);

        Assert.That(head.ExitStatus, Is.EqualTo(2));
        var numbers = MessageNumbers.In(head.Errors, HeadMotionMessages.TooFewPictures(0, 0));
        Assert.That(numbers[0], Is.LessThan(numbers[1]), "pictures found and needed");
        Assert.That(File.Exists(ProfilePath), Is.False);
    }

    static double MiddleOf(DrawnCode code) => code.Corners.Average(corner => corner[0]);

    static double SlopeOf(List<double> y, List<double> x)
    {
        var (meanY, meanX) = (y.Average(), x.Average());
        return y.Zip(x).Sum(pair => (pair.First - meanY) * (pair.Second - meanX)) / x.Sum(each => (each - meanX) * (each - meanX));
    }
}
