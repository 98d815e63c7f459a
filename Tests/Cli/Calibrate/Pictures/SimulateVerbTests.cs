using Nowpose.Cli.Calibrate.Simulate;
using Nowpose.Cli.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate.Pictures;

public sealed class SimulateVerbTests
{
    [Test]
    public async Task Simulate_CheckWithDefectivePicturesAndRollingShutter_MeetsTheLimits()
    {
        var run = await CliRun.OfAsync("calibrate", "simulate", "--check", "--pictures", "8", "--spoiled", "0.1", "--readout-ms=15", "--seed=1");

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Output + run.Errors);
        Assert.That(run.Output, Does.Contain("8 pictures").And.Contain(" 0 misread"));
    }

    /// <summary>
    /// Checks the simulation with twenty camera positions and different scenes, sizes, lights, LEDs and squares. Fails if more than one picture in
    /// ten cannot be read.
    /// </summary>
    [Test]
    public void SimulationCheck_TwentyCameraPositions_Reads90PercentWithoutMisreading()
    {
        var check = SimulationCheck.Run(new SimulationSettings { Pictures = 20, PicturesPerPlace = 1, Seed = 1 }, CancellationToken.None);

        var all = string.Join('\n', check.Lines());
        Assert.That(check.Pictures, Is.EqualTo(20));
        Assert.That(check.ReadOfGood, Is.GreaterThan(0.9), all);
        Assert.That(check.Misread, Is.Zero, all);
        Assert.That(check.MeanErrorMs, Is.EqualTo(0).Within(0.1), all);
        Assert.That(check.ErrorP95Ms, Is.LessThan(0.7), all);
    }

    // A picture shows a frame if its exposure overlaps the lit time, so its middle can be before or after the lit time.
    [Test]
    public void Moments_LongExposure_ScatterMoreThanTheLitTime()
    {
        var sweep = new SimulatedSweep(new SimulationSettings { Pictures = 2000, LoadSteps = 0, LitMs = 4, ExposureMs = 8, Seed = 1 });
        (double OffsetMs, double ExposureMs)[] moments =
            [.. sweep.Moments.Select(moment => ((moment.Middle - sweep.LightOf(moment.Frame)).TotalMilliseconds, moment.ExposureMs))];

        Assert.That(moments.Max(moment => Math.Abs(moment.OffsetMs)), Is.GreaterThan(3.5));
        Assert.That(moments.All(moment => Math.Abs(moment.OffsetMs) < (4 + moment.ExposureMs) / 2), Is.True);
    }

    [Test]
    public void Lines_NoPicture_StateNoShareAndNoError() =>
        Assert.That(new SimulationCheck().Lines(), Is.EqualTo(new[] { SimulationMessages.Read(0, 0, null, 0, SimulationCheck.MisreadMs) }));

    [Test]
    public void Write_Cancelled_ListsOnlyTheFinishedPictures()
    {
        using var folder = new TemporaryFolder();

        var made = SimulationOutput.Write(new SimulationSettings { Pictures = 5 }, folder.Path, new CancellationToken(canceled: true));

        var truth = File.ReadLines(Path.Combine(folder.Path, "truth.csv")).Skip(1).Select(line => line.Split(',')[0]).ToList();
        Assert.That(made, Is.LessThan(5));
        Assert.That(truth, Has.Count.EqualTo(made));
        Assert.That(truth.Where(name => !File.Exists(Path.Combine(folder.Path, "pictures", name))), Is.Empty);
    }

    [Test]
    public void Write_AfterARunThatFailed_ReplacesItsFiles()
    {
        using var folder = new TemporaryFolder();
        var settings = new SimulationSettings { Pictures = 1 };
        // A folder in the place of the picture cannot be written.
        var obstacle = Directory.CreateDirectory(Path.Combine(folder.Path, "pictures", "picture-00001.jpg"));
        Assert.That(() => SimulationOutput.Write(settings, folder.Path, CancellationToken.None), Throws.TypeOf<InputException>());
        obstacle.Delete();

        Assert.That(SimulationOutput.Write(settings, folder.Path, CancellationToken.None), Is.EqualTo(1));
    }

    [Test]
    public async Task Simulate_FolderWithOtherPictures_KeepsThem()
    {
        using var folder = new TemporaryFolder();
        var taken = Path.Combine(Directory.CreateDirectory(Path.Combine(folder.Path, "pictures")).FullName, "picture-00007.jpg");
        File.WriteAllText(taken, "by a camera");

        var run = await CliRun.OfAsync("calibrate", "simulate", "--pictures", "1", "--out", folder.Path);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain(SimulationMessages.OtherPictures(folder.Path, 1, "truth.csv")));
        Assert.That(File.ReadAllText(taken), Is.EqualTo("by a camera"));
        Assert.That(File.Exists(Path.Combine(folder.Path, "sweep.csv")), Is.False);
    }

    [Test]
    public async Task Simulate_FolderWithTheLogOfARealSweep_KeepsIt()
    {
        using var folder = new TemporaryFolder();
        var log = Path.Combine(folder.Path, "sweep.csv");
        File.WriteAllText(log, "by a headset");

        var run = await CliRun.OfAsync("calibrate", "simulate", "--pictures", "1", "--out", folder.Path);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(File.ReadAllText(log), Is.EqualTo("by a headset"));
    }
}
