using System.Text.Json;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>
/// Tests the verb <c>calibrate head</c>, from rendered pictures of a moving headset to a profile. Needs Node.js, as the build does.
/// </summary>
public sealed class HeadVerbTests : CalibrationFolder
{
    async Task<string> TakenAsync(string name, params string[] more)
    {
        var folder = Path.Combine(Folder, name);
        var run = await CliRun.OfAsync(["calibrate", "simulate", "--spoiled", "0.02", "--seed", "5", "--visu-ms", "42", "--out", folder, .. more]);
        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        return Path.Combine(folder, "pictures");
    }

    string SavedProfile()
    {
        var path = Path.Combine(Folder, "still.json");
        LatencyProfileFile.Save(path, new LatencyProfile(
            41.8, 1.2, new DisplayConditions("HoloLens 2", 60, "Direct3D11"), new DateTime(2026, 11, 20, 0, 0, 0, DateTimeKind.Utc),
            CalibrationMethod.VisibleLight, 300, 15, RenderTimeSourceKind.DisplayGpuTime));
        return path;
    }

    // Uses a headset with late-stage reprojection. HeadResultTests covers other latencies with simulated readings.
    [Test]
    public async Task Head_RenderedPictures_AddsTheLatencyToTheProfile()
    {
        var pictures = await TakenAsync("moving", "--pictures", "120", "--head-latency-ms", "2");

        var run = await CliRun.OfAsync(
            "calibrate", "head", pictures, "--profile", SavedProfile(), "--reprojection", "depth", "--out", Out, "--json");

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        using var json = JsonDocument.Parse(run.Output);
        double Number(string name) => json.RootElement.GetProperty(name).GetDouble();
        Assert.That(Number("head_latency_ms"), Is.EqualTo(2).Within(1), run.Output);
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
    public async Task Head_PicturesOfAStillHeadset_AreRejected()
    {
        var still = await TakenAsync("still", "--pictures", "4", "--load-steps", "0");

        var head = await CliRun.OfAsync("calibrate", "head", still, "--out", Out);

        Assert.That(head.ExitStatus, Is.EqualTo(2));
        var numbers = MessageNumbers.In(head.Errors, HeadMotionMessages.TooFewPictures(0, 0));
        Assert.That(numbers[0], Is.LessThan(numbers[1]), "pictures found and needed");
        Assert.That(File.Exists(ProfilePath), Is.False);
    }
}
