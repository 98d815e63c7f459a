using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Simulate;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Cli.Demo;
using Nowpose.Cli.Demo.Paper;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli;

/// <summary>Tests that <c>demo --paper</c> writes the results so far if the user interrupts its calibration.</summary>
public sealed class InterruptedPaperTests
{
    const int Pictures = 88;

    static readonly SimulatedSweep Sweep = new(new SimulationSettings { Pictures = Pictures, LoadSteps = 10, Seed = 5 });

    /// <summary>Returns the result of the first pictures, as a camera without error reads them.</summary>
    static VlcResult First(int pictures) => new([.. Sweep.Moments.Take(pictures).Select((moment, i) =>
    {
        var (headset, visu) = (TimestampCode.ValueOf(Sweep.StartOf(moment.Frame)), Sweep.VisuMsOf(moment));
        return new PictureResult($"picture {i + 1}", (headset + visu) % TimestampCode.PeriodMs, headset, visu, null);
    })]);

    static PaperCalibration Calibration(int pictures, bool isInterrupted) => PaperCalibration.Of(First(pictures), Sweep.Rows, Pictures, 0, isInterrupted);

    [TestCase(1)]
    [TestCase(4)]
    [TestCase(40)]
    public void Of_Interrupted_EvaluatesThePicturesSoFar(int pictures)
    {
        var calibration = Calibration(pictures, isInterrupted: true);

        Assert.That(calibration.Page.Warnings[0], Is.EqualTo(CalibrationMessages.Interrupted));
        Assert.That(calibration.Page.Facts, Has.One.EqualTo(new[] { "Pictures", FormattableString.Invariant($"{pictures}") }));
    }

    [Test]
    public void Of_InterruptedBeforeTheFirstPicture_ReturnsNull() => Assert.That(Calibration(0, isInterrupted: true), Is.Null);

    [Test]
    public void Of_CompleteWithoutAPicture_Throws() =>
        Assert.That(() => Calibration(0, isInterrupted: false), Throws.TypeOf<DemoFailedException>());

    [Test]
    public async Task WriteInterrupted_EarlierRun_ReplacesItByThePage()
    {
        using var folder = new TemporaryFolder();
        foreach (var name in new[] { "result.json", "frames.csv", "profile.json" }) File.WriteAllText(Path.Combine(folder.Path, name), "{}");

        var (_, output, errors) = await CapturedConsole.OfAsync(() =>
        {
            using var files = DemoOutput.At(folder.Path, isPaper: true);
            PaperSession.WriteInterrupted(Calibration(4, isInterrupted: true), files);
            return Task.FromResult(0);
        });

        var page = Path.Combine(folder.Path, "calibration.html");
        Assert.That(Directory.GetFiles(folder.Path), Is.EqualTo(new[] { page }));
        Assert.That(errors.TrimEnd(), Is.EqualTo(ConsoleMessages.CalibrationInterrupted(page)));
        Assert.That(output, Is.Empty);
    }
}
