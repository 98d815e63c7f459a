using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Head;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Cli.Messages;
using Nowpose.Latency.Conditions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>Tests the latency for head motion and L_visu, which are estimated independently, with simulated readings of known truth.</summary>
public sealed class HeadResultTests
{
    static HeadResult ResultOf(SwungPictures pictures) => new(new VlcResult(pictures.Take()));

    // With late-stage reprojection, the latency for head motion is a few ms; without it, it equals L_visu. If a runtime predicts too far ahead, it is
    // negative.
    [Test]
    public void HeadResult_AnyLatencyAndLVisu_EstimatesThemSeparately(
        [Values(-3, 0, 2, 5, 20, 40)] double latencyMs, [Values(25, 40, 60)] double visuMs, [Values(1, 2)] int seed)
    {
        var result = ResultOf(new SwungPictures { LatencyMs = latencyMs, VisuMs = visuMs, Seed = seed });

        Assert.That(result.LatencyMs, Is.EqualTo(latencyMs).Within(0.5), "seed " + seed);
        Assert.That(result.VisuMs, Is.EqualTo(visuMs).Within(0.5));
        Assert.That(result.UncertaintyMs, Is.LessThan(0.6));
    }

    [Test]
    public void HeadResult_TwoHundredRecordings_UncertaintyCoversTheTruthIn95PercentOfThem()
    {
        var covered = Enumerable.Range(0, 200).Count(seed =>
        {
            var result = ResultOf(new SwungPictures { LatencyMs = 10, Seed = seed, NoisePx = 1 });
            return Math.Abs(result.LatencyMs - 10) <= result.UncertaintyMs;
        });

        Assert.That(covered, Is.GreaterThanOrEqualTo(180));
    }

    [Test]
    public void HeadResult_RollingShutterDistanceAndDistortion_DoNotAffectTheLatency()
    {
        var result = ResultOf(new SwungPictures { LatencyMs = 12, LaterMs = 6, Scale = 1.1, Distortion = 1e-4 });

        Assert.That(result.LatencyMs, Is.EqualTo(12).Within(0.7));
    }

    [Test]
    public void HeadPage_PicturesInTheOrderOfTime_PlotsEachOffsetAtItsSpeedInIncreasingOrder()
    {
        var result = ResultOf(new SwungPictures { LatencyMs = 12 });

        var trace = HeadPage.Of(result, null, new DisplayConditions()).Sections[0].Plots[0].Traces[0];

        Assert.That(trace.X, Is.Ordered.Ascending.And.Unique);
        var expected = result.Used.OrderBy(picture => picture.Speed).ToArray();
        Assert.That(trace.X, Is.EqualTo(expected.Select(picture => picture.Speed)).Within(0.01));
        Assert.That(trace.Y, Is.EqualTo(expected.Select(picture => picture.Offset)));
    }

    [Test]
    public void HeadResult_RejectedMisreadAndLatePictures_AreExcluded()
    {
        var pictures = new SwungPictures { LatencyMs = 12 }.Take().ToArray();
        for (var i = 0; i < pictures.Length; i += 12) pictures[i] = PictureResult.Not(pictures[i].File, "undecided");
        for (var i = 5; i < pictures.Length; i += 30)
            pictures[i] = pictures[i] with { VisuMs = pictures[i].VisuMs + 17, HeadsetMs = pictures[i].HeadsetMs - 17 };
        for (var i = 7; i < pictures.Length; i += 60)
            pictures[i] = pictures[i] with { Places = pictures[i].Places with { Headset = (900, 600) } };

        var result = new HeadResult(new VlcResult(pictures));

        Assert.That(result.LatencyMs, Is.EqualTo(12).Within(0.6));
        Assert.That(result.Used, Has.Count.InRange(200, 270));
    }

    // The hologram follows the head, as with the component Body Follow.
    [Test]
    public void HeadResult_HologramFollowsTheHead_Throws()
    {
        var fault = Assert.Throws<InputException>(() => ResultOf(new SwungPictures { Scale = 0 }));

        Assert.That(MessageNumbers.In(fault.Message, HeadMotionMessages.NotWorldLocked(1))[0], Is.LessThan(0.3));
    }

    static readonly object[][] TooLittle =
    [
        [new SwungPictures { AmplitudePx = 2 }, HeadMotionMessages.TooSlow(0, 0).Split(" 0 ")[0]],
        [new SwungPictures { Count = 40 }, HeadMotionMessages.TooFewPictures(36, 0).Split(';')[0]],
        [new SwungPictures { PeriodSeconds = 60, AmplitudePx = 3000 }, HeadMotionMessages.TooFewTurns(0, 0, 0).Split(": ")[1]],
    ];

    [TestCaseSource(nameof(TooLittle))]
    public void HeadResult_TooLittleMotion_Throws(object pictures, string message)
    {
        Assert.That(() => ResultOf((SwungPictures)pictures), Throws.TypeOf<InputException>().With.Message.Contains(message));
    }

    [Test]
    public void ResultOf_TooFewPictures_ThrowsUnlessTheRunWasCancelled()
    {
        var few = new VlcResult(new SwungPictures { Count = 40 }.Take());

        Assert.That(HeadVerb.ResultOf(few, "pictures", new CancellationToken(canceled: true)), Is.Null);
        Assert.That(
            () => HeadVerb.ResultOf(few, "pictures", CancellationToken.None),
            Throws.TypeOf<InputException>().With.Message.StartsWith("pictures: "));
    }
}
