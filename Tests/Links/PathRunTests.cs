using Nowpose.Benchmarks.Paths;
using Nowpose.Simulation;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Links;

public class PathRunTests
{
    const double SizeMs = 4;

    /// <summary>On a quiet link exchanges are rare when the path changes, and frequent as soon as the clock is known less well.</summary>
    [Test]
    public void Play_ChangeWhileExchangesAreRare_ErrorAndSkewStayAsBefore(
        [Range(7000, 7005)] int seed, [Values("requests longer", "replies longer", "both longer")] string change)
    {
        var run = PathRun.Play(LinkProfile.Clean, Named(change), SizeMs, ClockEstimators.Default, seed);

        Assert.That(run.ErrorMs, Is.LessThan(0.1));
        Assert.That(run.SkewPpm, Is.LessThan(2));
        Assert.That(run.Within, Is.EqualTo(1));
    }

    [Test]
    public void Play_PapersEstimator_ErrsByHalfTheChangeOrMore()
    {
        var change = Named("requests longer");

        var run = PathRun.Play(LinkProfile.Clean, change, SizeMs, ClockEstimators.Ransac, 7000);

        Assert.That(run.ErrorMs, Is.GreaterThan(0.9 * change.Limit * SizeMs));
    }

    static PathChange Named(string name) => PathChange.All.Single(change => change.Name == name);
}
