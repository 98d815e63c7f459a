using NUnit.Framework;
using Nowpose.Gateway.Status;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class ForwardingTimesTests
{
    static TimeSpan Ms(double value) => TimeSpan.FromMilliseconds(value);

    [Test]
    public void SortedRecent_TimesOlderThanAMinute_ExcludesThem()
    {
        var time = new SteppedTime();
        var times = new ForwardingTimes(time);
        times.Add(Ms(40));

        time.Advance(TimeSpan.FromSeconds(59));
        times.Add(Ms(2));
        Assert.That(times.SortedRecent(), Is.EqualTo(new[] { Ms(2), Ms(40) }));
        time.Advance(TimeSpan.FromSeconds(1));
        Assert.That(times.SortedRecent(), Is.EqualTo(new[] { Ms(2) }));
        time.Advance(TimeSpan.FromSeconds(59));
        Assert.That(times.SortedRecent(), Is.Empty);
    }

    [Test]
    public void SortedRecent_ManyTimes_ReturnsTheNewest()
    {
        var times = new ForwardingTimes(new SteppedTime());

        for (var i = 0; i < 10_000; i++) times.Add(new TimeSpan(i));

        Assert.That(times.SortedRecent(), Is.EqualTo(Enumerable.Range(10_000 - 8192, 8192).Select(i => new TimeSpan(i))));
    }

    [Test]
    public void Counts_TimesAtTheLimits_AreInTheCorrectBuckets()
    {
        var time = new SteppedTime();
        var times = new ForwardingTimes(time);
        times.Add(TimeSpan.FromMilliseconds(5));
        times.Add(TimeSpan.FromMilliseconds(5.0001));
        times.Add(TimeSpan.FromSeconds(2));

        time.Advance(TimeSpan.FromHours(1));
        times.SortedRecent();

        var five = Array.IndexOf(ForwardingTimes.Limits, 0.005);
        Assert.That(times.Counts()[five], Is.EqualTo(1), "a value equal to the upper limit is in its bucket");
        Assert.That(times.Counts()[five + 1], Is.EqualTo(1));
        Assert.That(times.Counts()[^1], Is.EqualTo(1));
        Assert.That(times.Sum, Is.EqualTo(2.0100001).Within(1e-9));
    }
}
