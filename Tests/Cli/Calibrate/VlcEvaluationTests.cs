using System.Text.Json;
using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Sweep;
using Nowpose.Messages;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>Tests the evaluation of readings.</summary>
public sealed class VlcEvaluationTests
{
    const double TrueMs = 40;

    /// <summary>Simulates a sweep across the render time limit. The log contains every frame; every fourth frame has a picture.</summary>
    static (List<SweepRow> Rows, VlcResult Result) Sweep(
        Func<double, double> renderMs, string device = "HoloLens 2 (Microsoft Corporation)", double displayHz = 60, int framesPerLoad = 120)
    {
        var random = new Random(3);
        var pipeline = new DisplayPipeline(3, new DisplayPipelineSettings(plateauMs: TrueMs));
        var rows = new List<SweepRow>();
        var pictures = new List<PictureResult>();
        for (var i = 0; i < 21 * framesPerLoad; i++)
        {
            var vertices = i / framesPerLoad * 100_000;
            var frame = pipeline.Next(vertices);
            var start = ControlTime.FromSeconds(1000) + frame.Start;
            rows.Add(new SweepRow(start, vertices, renderMs(frame.RenderTime.TotalMilliseconds), RenderTimeSourceKind.EngineGpuTime, device, displayHz));
            if (i % 4 != 0) continue;
            var visu = frame.Visualisation.TotalMilliseconds + random.NextDouble() - 0.5;
            var headset = TimestampCode.ValueOf(start);
            pictures.Add(new PictureResult("p" + i, (headset + visu) % TimestampCode.PeriodMs, headset, visu, null));
        }
        return (rows, new VlcResult(pictures));
    }

    static VlcEvaluation Evaluate(VlcResult result, IReadOnlyList<SweepRow> sweep, string device = null, double? displayHz = null) =>
        new(result, sweep, EarlierProfile.Read(null, new DisplayConditions(device, displayHz), sweep == null ? null : Conditions(sweep)));

    static DisplayConditions Conditions(IReadOnlyList<SweepRow> sweep) => new(SweepTable.Device(sweep), SweepTable.DisplayHz(sweep));

    [Test]
    public void Profile_SourceRespondsToLoad_HasLVisuAndLimit()
    {
        var (rows, result) = Sweep(ms => ms);

        var profile = Evaluate(result, rows).Profile;

        Assert.That(profile.Visualisation.Length.TotalMilliseconds, Is.EqualTo(TrueMs).Within(0.2));
        Assert.That(profile.Range.Limit.TotalMilliseconds, Is.EqualTo(15.17).Within(0.3));
        Assert.That(profile.Range.Source, Is.EqualTo(RenderTimeSourceKind.EngineGpuTime));
        Assert.That(profile.Device, Is.EqualTo("HoloLens 2 (Microsoft Corporation)"));
        Assert.That(profile.DisplayHz, Is.EqualTo(60));
    }

    [Test]
    public void Profile_SourceDoesNotRespondToLoad_HasLVisuWithoutLimit()
    {
        var (rows, result) = Sweep(_ => 2);

        var evaluation = Evaluate(result, rows);

        Assert.That(result.Read.Average(picture => picture.VisuMs), Is.GreaterThan(TrueMs + 5), "pictures at high loads are late");
        Assert.That(evaluation.Profile.Visualisation.Length.TotalMilliseconds, Is.EqualTo(TrueMs).Within(0.3));
        Assert.That(evaluation.Profile.Spread.TotalMilliseconds, Is.LessThan(2));
        Assert.That(evaluation.Profile.Range, Is.Null);
        Assert.That(evaluation.Page.Warnings, Has.Some.Contains(SweepMessages.NoResponse("|", 0, "").Split('|')[0]));
        Assert.That(evaluation.Profile.Measurements, Is.InRange(0.4 * result.Read.Count, 0.75 * result.Read.Count), "only the pictures of the plateau are counted");
    }

    [Test]
    public void Profile_SourceChangesTemporarily_HasTheLimitOfTheMostFrequentSource()
    {
        var (rows, result) = Sweep(ms => ms);
        var mixed = rows.Select((row, i) => i % 10 != 0 ? row : new SweepRow(
            row.FrameStart, row.Vertices, 30, RenderTimeSourceKind.GpuCompletion, row.Device, row.DisplayHz)).ToList();

        var evaluation = Evaluate(result, mixed);

        Assert.That(evaluation.Profile.Range.Limit.TotalMilliseconds, Is.EqualTo(15.17).Within(0.3));
        Assert.That(evaluation.Profile.RenderTimeSource, Is.EqualTo(RenderTimeSourceKind.EngineGpuTime));
        Assert.That(evaluation.Pictures.Select(picture => picture.RenderMs), Has.None.EqualTo(30));
        Assert.That(evaluation.Page.Warnings, Has.Some.EqualTo(
            VlcMessages.OtherSource(252, 2520, "engine_gpu_time")));
    }

    [Test]
    public void Profile_DeviceNotGiven_HasAnEmptyDevice()
    {
        var (rows, result) = Sweep(ms => ms, device: "", displayHz: double.NaN);

        foreach (var sweep in new[] { rows, null })
        {
            var profile = Evaluate(result, sweep).Profile;

            Assert.That(profile.Device, Is.Empty);
            Assert.That(profile.DisplayHz, Is.Zero);
            Assert.That(profile.RefusalFor("HoloLens 2 (Microsoft Corporation)", 60), Is.Null);
        }
    }

    [Test]
    public void Profile_NoSweep_ExcludesLateFrames()
    {
        PictureResult[] pictures = [.. Enumerable.Range(0, 50).Select(i => new PictureResult("p" + i, 0, i, i % 10 == 9 ? 56.7 : 40 + i % 3 - 1, null))];

        var profile = Evaluate(new VlcResult(pictures), null, "headset", 72).Profile;

        Assert.That(profile.Visualisation.Length.TotalMilliseconds, Is.EqualTo(40).Within(0.1));
        Assert.That(profile.Measurements, Is.EqualTo(45));
        Assert.That((profile.Device, profile.DisplayHz), Is.EqualTo(("headset", 72)));
    }

    [Test]
    public void Evaluation_SweepLogFromAnotherRecording_Throws()
    {
        var (rows, result) = Sweep(ms => ms);
        var other = rows.Select(row => new SweepRow(
            row.FrameStart + TimeSpan.FromMilliseconds(5), row.Vertices, row.RenderMs, row.Source, row.Device, row.DisplayHz)).ToList();

        Assert.That(() => Evaluate(result, other),
            Throws.TypeOf<InputException>().With.Message.EqualTo(VlcMessages.OtherSweep(0, result.Read.Count)));
    }

    /// <summary>The simulated sweep lasts 126 s, which is the default duration.</summary>
    [Test]
    public void Evaluation_LongSweep_IsIndependentOfTheGivenOrder([Values(1, 2, 3)] int seed)
    {
        var (rows, result) = Sweep(ms => ms, framesPerLoad: 360);
        PictureResult[] shuffled = [.. result.Pictures];
        new Random(seed).Shuffle(shuffled);

        var inOrder = Evaluate(result, rows);
        foreach (var given in new[] { new VlcResult([.. result.Pictures.Reverse()]), new VlcResult(shuffled) })
        {
            var evaluation = Evaluate(given, rows);
            Assert.That(evaluation.Pictures, Is.EqualTo(inOrder.Pictures), $"seed {seed}");
            Assert.That(evaluation.Profile.Range.Limit, Is.EqualTo(inOrder.Profile.Range.Limit), $"seed {seed}");
        }
        Assert.That(inOrder.Profile.Range.Limit.TotalMilliseconds, Is.EqualTo(15.17).Within(0.3));
    }

    [Test]
    public void Evaluation_LongSweepWithNamesInAnotherOrder_IsRejected([Values(1, 2, 3)] int seed)
    {
        var (rows, result) = Sweep(ms => ms, framesPerLoad: 360);
        string[] names = [.. result.Pictures.Select(picture => picture.File)];
        new Random(seed).Shuffle(names);

        var renamed = new VlcResult([.. result.Pictures.Zip(names, (picture, name) => picture with { File = name })]);

        Assert.That(() => Evaluate(renamed, rows), Throws.TypeOf<InputException>().With.Message.EqualTo(VlcMessages.OrderUnknown(65.536)), $"seed {seed}");
    }

    [Test]
    public void Evaluation_SeveralLoadsWithoutSweep_AddsAWarning()
    {
        var (_, result) = Sweep(ms => ms);

        var evaluation = Evaluate(result, null);

        Assert.That(evaluation.Profile.Visualisation.Length.TotalMilliseconds, Is.EqualTo(TrueMs).Within(0.3));
        Assert.That(evaluation.Page.Warnings, Has.Some.Contains("several loads"));
    }

    [Test]
    public void Profile_LargeScatter_IsNull()
    {
        var random = new Random(2);
        PictureResult[] pictures = [.. Enumerable.Range(0, 100).Select(i => new PictureResult("p" + i, 0, i, 20 + 60 * random.NextDouble(), null))];

        var evaluation = Evaluate(new VlcResult(pictures), null);

        Assert.That(evaluation.Profile, Is.Null);
        Assert.That(evaluation.Page.Warnings, Has.Some.Contains(VlcMessages.Scatters(null)["L_visu scatters by ".Length..]));
    }

    /// <summary>L_visu scatters too much for a profile, and a quarter of the pictures are late.</summary>
    [Test]
    public void Json_NoProfile_HasTheMeanWithoutLatePictures()
    {
        PictureResult[] pictures = [.. Enumerable.Range(0, 40).Select(i => new PictureResult("p" + i, 0, i, i < 10 ? 400 : 30 + 2 * i, null))];
        var result = new VlcResult(pictures);

        var evaluation = Evaluate(result, null);

        Assert.That(evaluation.Profile, Is.Null);
        using var json = JsonDocument.Parse(VlcJson.Of(result, evaluation.Profile));
        Assert.That(json.RootElement.GetProperty("visu_ms_mean").GetDouble(), Is.EqualTo(pictures.Skip(10).Average(picture => picture.VisuMs)).Within(1e-9));
    }

    [Test]
    public void Profile_SinglePicture_IsNull()
    {
        var evaluation = Evaluate(new VlcResult([new PictureResult("p", 0, 0, 40, null)]), null);

        Assert.That(evaluation.Profile, Is.Null);
        Assert.That(evaluation.Page.Warnings, Has.Some.EqualTo(VlcMessages.OnePicture));
    }
}
