using Nowpose.Cli.Calibrate.Simulate;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Vision;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>Tests the evaluation of rendered pictures in series. Needs Node.js, as the build does.</summary>
public sealed class VlcRunTests
{
    static PictureResult[] Read(SimulationSettings settings, IReadOnlyList<int> pictures)
    {
        var camera = new SimulatedCamera(settings, new SimulatedSweep(settings));
        var shots = pictures.Select(picture => PictureRequest.Made(camera.Take(picture, out _)));
        return [.. new VlcRun(new PictureReader(0, 0)).Run(shots, pictures.Count, place => $"{pictures[place]}", default).Pictures];
    }

    // The camera is at another place in each picture, so the code moves from picture to picture as if the headset turned.
    [Test]
    public void Run_PictureBetweenOthersAndAlone_HasTheSameResult()
    {
        var settings = new SimulationSettings { Pictures = 60, PicturesPerPlace = 1, Spoiled = 0, LoadSteps = 0, Seed = 5 };

        var among = Read(settings, [51, 52, 53])[1];
        var alone = Read(settings, [52])[0];

        Assert.That(alone.VisuMs, Is.EqualTo(38.2).Within(0.1));
        Assert.That((among.Fault, among.VisuMs), Is.EqualTo((alone.Fault, alone.VisuMs)));
    }

    [Test]
    public void Run_MovingHeadset_ReadsTheTrueLatencies()
    {
        var settings = new SimulationSettings { Pictures = 8, HeadLatencyMs = 2, Spoiled = 0, LoadSteps = 0, Seed = 5 };
        var sweep = new SimulatedSweep(settings);

        var read = Read(settings, [.. Enumerable.Range(0, settings.Pictures)]);

        Assert.That(read.Count(picture => picture.IsRead), Is.GreaterThan(5));
        foreach (var picture in read.Where(picture => picture.IsRead))
            Assert.That(picture.VisuMs, Is.EqualTo(sweep.VisuMsOf(sweep.Moments[int.Parse(picture.File)])).Within(1), $"picture {picture.File}, seed 5");
    }
}
