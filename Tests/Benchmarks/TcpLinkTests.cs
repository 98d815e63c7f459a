using NUnit.Framework;
using Nowpose.Benchmarks.Links;
using Nowpose.Session;

namespace Nowpose.Headless.Tests.Benchmarks;

/// <summary>
/// Tests the accuracy of the displayed pose over slow and lossy links, including TCP's retransmissions and head-of-line blocking.
/// </summary>
public class TcpLinkTests
{
    const int FirstSeed = 300, Seeds = 3;

    static TcpRun[] Runs(string link, double seconds) =>
        Enumerable.Range(FirstSeed, Seeds).Select(seed => new TcpRun(LinkProfile.Named(link), seed).Run(seconds)).ToArray();

    static double Median(double[] values) => values.OrderBy(v => v).ElementAt(values.Length / 2);

    [TestCase("clean", 0.94, 1.5)]
    [TestCase("wifi", 0.94, 3)]
    [TestCase("lossy", 0.92, 5)]
    [TestCase("cellular", 0.92, 8)]
    [TestCase("bad", 0.8, 30)]
    public void Pose_SlowOrLossyLink_IsCurrentWithinSeconds(string link, double minReduction, double synchronisedSeconds)
    {
        var runs = Runs(link, 30);

        var seeds = "seeds from " + FirstSeed;
        Assert.That(Median(runs.Select(run => run.FirstCurrent).ToArray()), Is.LessThan(1), seeds);
        Assert.That(runs.Max(run => run.FirstCurrent), Is.LessThan(2), seeds);
        Assert.That(runs.Max(run => run.FirstIn(ClockState.Synchronised)), Is.LessThan(synchronisedSeconds), seeds);
        Assert.That(runs.Min(run => run.CurrentShare), Is.GreaterThan(0.95), seeds);
        Assert.That(runs.Average(run => run.ClockErrorBeyondStated), Is.LessThan(0.01), seeds);
        Assert.That(
            runs.SelectMany(run => run.Frames).Where(frame => frame.IsCurrent).Max(frame => Math.Abs(frame.ClockErrorMs)), Is.LessThan(10.5), seeds);
        Assert.That(Median(runs.Select(run => run.Reduction).ToArray()), Is.GreaterThan(minReduction), seeds);
    }

    [Test]
    public void Pose_LinkStalls_IsHeldAndCurrentAgainWithinHalfASecond()
    {
        var profile = LinkProfile.Roaming;
        foreach (var run in Runs("roaming", 30))
            for (var stall = profile.StallInterval.TotalSeconds; stall < 27; stall += profile.StallInterval.TotalSeconds)
            {
                var end = stall + profile.StallLength.TotalSeconds;
                Assert.That(run.Frames.Where(frame => frame.At > stall + 0.3 && frame.At < end).Any(frame => frame.IsCurrent), Is.False,
                    "stall at " + stall);
                Assert.That(run.Frames.Where(frame => frame.At > end + 0.5 && frame.At < stall + 8).All(frame => frame.IsCurrent), Is.True,
                    "after " + end);
            }
    }

    [Test]
    public void State_CoarseClock_HasAnEstimatedErrorAbove700Microseconds()
    {
        foreach (var run in Runs("bad", 10))
        {
            var coarse = run.Frames.Where(frame => frame.Clock == ClockState.Coarse).ToArray();

            Assert.That(coarse, Is.Not.Empty);
            Assert.That(coarse.Select(frame => frame.StatedMs), Has.All.GreaterThan(0.7));
            Assert.That(coarse.Average(frame => Math.Abs(frame.ClockErrorMs)), Is.LessThan(3));
        }
    }
}
