using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Head;
using Nowpose.Cli.Calibrate.Simulate;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>A video whose rate is nearly a part of the display's rate shows the same part of the lit time in all pictures.</summary>
public sealed class PictureRateTests
{
    const double TrueMs = 40;

    // Readings without error. A picture without enough light of one frame is rejected.
    static VlcResult Filmed(double? picturesPerSecond, int seed, int pictures = 60, double exposureMs = 8)
    {
        var sweep = new SimulatedSweep(new SimulationSettings
        {
            Pictures = pictures, LoadSteps = 0, ExposureMs = exposureMs, PicturesPerSecond = picturesPerSecond, Seed = seed,
        });
        bool IsLit(SimulatedMoment moment) => sweep.LightOf(moment, moment.Middle).Any(light => light.Frame == moment.Frame && light.Share > 0.25);
        return new VlcResult([.. sweep.Moments.Select((moment, i) => IsLit(moment)
            ? new PictureResult($"p{i}", moment.Middle.SinceEpoch.TotalMilliseconds % TimestampCode.PeriodMs, 0, sweep.Measured(moment).VisuMs, null)
            : PictureResult.Not($"p{i}", "dark"))]);
    }

    static string Start => VlcMessages.NarrowExposures(0, 0).Split('0')[0];

    static IEnumerable<string> Warnings(VlcResult result, double? displayHz) =>
        new VlcEvaluation(result, null, EarlierProfile.Read(null, new DisplayConditions(displayHz: displayHz))).Page.Warnings;

    [Test]
    public void Evaluation_CameraInStepWithTheDisplay_WarnsIfLVisuIsWrong([Values(30, 60)] double rate, [Range(1, 20)] int seed)
    {
        var result = Filmed(rate, seed);
        // Depending on the first picture, a video can also be dark throughout.
        if (result.Read.Count < 30) return;

        Assert.That(Warnings(result, null), Has.Some.StartsWith(Start), $"L_visu {result.Mean} ms instead of {TrueMs} ms");
    }

    [Test]
    public void Evaluation_CameraNotInStep_HasNoWarning([Values(25, 50, null)] double? rate, [Values(4, 8)] double exposureMs, [Range(1, 20)] int seed)
    {
        var result = Filmed(rate, seed, exposureMs: exposureMs);

        Assert.That(Warnings(result, 60), Has.None.StartsWith(Start));
        Assert.That(result.Mean, Is.EqualTo(TrueMs).Within(2));
    }

    [Test]
    public void HeadResult_CameraInStepWithTheDisplay_UncertaintyIncludesTheErrorOfLVisu()
    {
        var pictures = new SwungPictures { LatencyMs = 5 }.Take();
        // All pictures show the beginning of the light: every picture 3 ms earlier than the middle.
        var early = new VlcResult([.. new SwungPictures { LatencyMs = 5, ExposureOffsetMs = -3, LitMs = 0.5 }.Take()]);

        var (unknown, known) = (new HeadResult(early), new HeadResult(early, 60));

        Assert.That(Math.Abs(known.LatencyMs - 5), Is.InRange(2.5, known.UncertaintyMs));
        Assert.That(unknown.UncertaintyMs, Is.LessThan(1), "without the display rate, the error has no bound");
        Assert.That(HeadPage.Of(unknown, null, new DisplayConditions()).Warnings, Has.Some.StartsWith(Start));
        Assert.That(HeadPage.Of(new HeadResult(new VlcResult(pictures), 120), null, new DisplayConditions()).Warnings, Has.None.StartsWith(Start));
    }
}
