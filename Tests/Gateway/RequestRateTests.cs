using System.Diagnostics;
using NUnit.Framework;
using Nowpose.Gateway.Sync;

namespace Nowpose.Headless.Tests.Gateway;

public class RequestRateTests
{
    static readonly long Millisecond = Stopwatch.Frequency / 1000;

    [Test]
    public void TryTake_AtTheLimitForAnHour_NeverRefuses()
    {
        var rate = new RequestRate(100);

        for (var i = 0; i < 360_000; i++)
            Assert.That(rate.TryTake(i * 10 * Millisecond), Is.True, $"request {i}");
    }

    [Test]
    public void TryTake_OneRequestTooManyWithinASecond_IsRefused()
    {
        var rate = new RequestRate(100);
        for (var i = 0; i < 100; i++)
            Assert.That(rate.TryTake(i * Millisecond), Is.True);

        Assert.That(rate.TryTake(999 * Millisecond), Is.False);
        Assert.That(rate.TryTake(1000 * Millisecond), Is.True);
    }
}
