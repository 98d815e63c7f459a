using NUnit.Framework;
using Nowpose.Gateway.Status;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class ForwardingTimesTests
{
    [Test]
    public void Percentile_TimesOlderThanAMinute_ExcludesThem()
    {
        var time = new SteppedTime();
        var times = new ForwardingTimes(time);
        times.Add(TimeSpan.FromMilliseconds(40));

        time.Advance(TimeSpan.FromSeconds(29));
        Assert.That(times.Percentile(0.99)?.TotalMilliseconds, Is.EqualTo(40).Within(7).Percent);
        time.Advance(TimeSpan.FromSeconds(2));
        times.Add(TimeSpan.FromMilliseconds(2));
        Assert.That(times.Percentile(0.99)?.TotalMilliseconds, Is.EqualTo(40).Within(7).Percent, "still within the minute");
        time.Advance(TimeSpan.FromSeconds(31));
        Assert.That(times.Percentile(0.99)?.TotalMilliseconds, Is.EqualTo(2).Within(7).Percent);
        time.Advance(TimeSpan.FromSeconds(61));
        Assert.That(times.Percentile(0.99), Is.Null);
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
        times.Percentile(0.5);

        var five = Array.IndexOf(ForwardingTimes.Limits, 0.005);
        Assert.That(times.Counts()[five], Is.EqualTo(1), "a value equal to the upper limit is in its bucket");
        Assert.That(times.Counts()[five + 1], Is.EqualTo(1));
        Assert.That(times.Counts()[^1], Is.EqualTo(1));
        Assert.That(times.Sum, Is.EqualTo(2.0100001).Within(1e-9));
    }
}
