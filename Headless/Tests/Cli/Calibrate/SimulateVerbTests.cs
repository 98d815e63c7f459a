using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

[NonParallelizable]
public sealed class SimulateVerbTests
{
    [TestCase("--readout-ms=0", "--seed=11")]
    [TestCase("--readout-ms=15", "--seed=1")]
    public async Task Check_SpoiledPicturesAmongThem_MeetsTheLimits(string readout, string seed)
    {
        var run = await CliRun.OfAsync("calibrate", "simulate", "--check", "--pictures", "40", "--spoiled", "0.1", readout, seed);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Output + run.Errors);
        Assert.That(run.Output, Does.Contain("40 pictures").And.Contain(" 0 misread"));
    }
}
