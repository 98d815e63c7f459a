using NUnit.Framework;
using Nowpose.Gateway.Status;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class LatencyHistogramTests
{
    static readonly LatencyHistogram None = new();

    [TestCase(0.5)]
    [TestCase(0.95)]
    [TestCase(0.99)]
    public void Percentile_ManyDurations_IsTooLongByAtMostOneBucket(double fraction)
    {
        const int Seed = 7;
        var random = new Random(Seed);
        var histogram = new LatencyHistogram();
        // The durations are from 1 µs to 10 s, with about the same number in each decade.
        var durations = Enumerable.Range(0, 20_000).Select(_ => TimeSpan.FromSeconds(Math.Pow(10, -6 + 7 * random.NextDouble()))).ToArray();
        foreach (var duration in durations) histogram.Add(duration);
        Array.Sort(durations);

        var estimate = LatencyHistogram.Percentile(histogram, None, fraction).Value;

        var truth = durations[(int)Math.Ceiling(fraction * durations.Length) - 1];
        Assert.That(estimate / truth, Is.InRange(1.0, 1.0626), $"seed {Seed}");
    }

    [Test]
    public void Percentile_TwoHistograms_UsesTheDurationsOfBoth()
    {
        var (fast, slow) = (new LatencyHistogram(), new LatencyHistogram());
        for (var i = 0; i < 99; i++) fast.Add(new TimeSpan(3));
        slow.Add(TimeSpan.FromSeconds(1));

        Assert.That(LatencyHistogram.Percentile(fast, slow, 0.99), Is.EqualTo(new TimeSpan(4)));
        Assert.That(LatencyHistogram.Percentile(fast, slow, 1).Value.TotalSeconds, Is.InRange(1, 1.0626));
    }

    [Test]
    public void Percentile_Empty_IsNull() => Assert.That(LatencyHistogram.Percentile(None, None, 0.5), Is.Null);

    [TestCase(-1)]
    [TestCase(long.MaxValue)]
    [TestCase(long.MinValue)]
    public void Add_DurationOutsideAllBuckets_CountsInTheNearestBucket(long ticks)
    {
        var histogram = new LatencyHistogram();

        histogram.Add(new TimeSpan(ticks));

        var expected = ticks < 0 ? new TimeSpan(1) : TimeSpan.FromTicks(1L << 30);
        Assert.That(LatencyHistogram.Percentile(histogram, None, 0.5), Is.EqualTo(expected));
    }
}
