using System.Collections.Concurrent;
using Nowpose.Benchmarks.Paths;
using Nowpose.Simulation;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Network;

public class PathRunTests
{
    const double SizeMs = 4;
    const int FirstSeed = 7000, Seeds = 2;

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

    /// <summary>All links and changes but the one that is known to miss its limit: the skew of "bad, shorter than ever" moves by up to 8 ppm.</summary>
    static IEnumerable<TestCaseData> ChangesWithinLimits =>
        from link in LinkProfile.All
        where link.StallInterval == TimeSpan.Zero
        from change in PathChange.All
        where link != LinkProfile.Bad || change.Name != "shorter than ever"
        select new TestCaseData(link.Name, change.Name);

    /// <summary>The limits of the verb `paths`, which plays more seeds and sizes.</summary>
    [TestCaseSource(nameof(ChangesWithinLimits))]
    public void Missed_ChangeOnALink_IsEmpty(string link, string change) =>
        Assert.That(Cell(link, change, SizeMs, ClockEstimators.Default).Missed, Is.Empty, $"seeds {FirstSeed} and up");

    /// <summary>Half a millisecond is recognised by the round trips, where the margin for a wrong skew alone would hide it.</summary>
    [TestCase("wifi", "requests longer")]
    [TestCase("wifi", "longer and back")]
    [TestCase("cellular", "requests longer")]
    [TestCase("cellular", "replies longer")]
    [TestCase("cellular", "longer and back")]
    public void Missed_SmallChange_IsEmpty(string link, string change) =>
        Assert.That(Cell(link, change, 0.5, ClockEstimators.Default).Missed, Is.Empty, $"seeds {FirstSeed} and up");

    [Test]
    public void Missed_PapersEstimator_NamesTheSkew()
    {
        var missed = Cell("clean", "requests longer", SizeMs, ClockEstimators.Ransac).Missed.ToArray();

        Assert.That(missed, Has.Some.Contains("skew moved by"));
        Assert.That(missed, Has.All.StartsWith("clean, requests longer, 4 ms: "));
    }

    [Test]
    public void Play_PapersEstimator_ErrsByHalfTheChangeOrMore()
    {
        var change = Named("requests longer");

        var run = PathRun.Play(LinkProfile.Clean, change, SizeMs, ClockEstimators.Ransac, 7000);

        Assert.That(run.ErrorMs, Is.GreaterThan(0.9 * change.Limit * SizeMs));
    }

    static PathCell Cell(string link, string change, double sizeMs, string estimator)
    {
        var unchanged = Unchanged.GetOrAdd((link, estimator), key => new Lazy<PathRun[]>(() => Play(key.Link, PathChange.None, 0, key.Estimator)));
        return new PathCell(LinkProfile.Named(link), Named(change), sizeMs, Play(link, Named(change), sizeMs, estimator), unchanged.Value);
    }

    // The same for all changes.
    static readonly ConcurrentDictionary<(string Link, string Estimator), Lazy<PathRun[]>> Unchanged = new();

    static PathRun[] Play(string link, PathChange change, double sizeMs, string estimator) =>
        [.. Enumerable.Range(FirstSeed, Seeds).Select(seed => PathRun.Play(LinkProfile.Named(link), change, sizeMs, estimator, seed))];

    static PathChange Named(string name) => PathChange.All.Single(change => change.Name == name);
}
