using System.Diagnostics;
using NUnit.Framework;
using Nowpose.Gateway.Clock;

namespace Nowpose.Headless.Tests.Gateway;

public class StopwatchControlClockTests
{
    static readonly ControlTime Epoch = ControlTime.FromSeconds(123);

    [TestCase(0)]
    [TestCase(80e-6)]
    [TestCase(-80e-6)]
    public void AtCount_AnHourLater_IncludesTheSkew(double skew)
    {
        var clock = new StopwatchControlClock(Epoch, skew);
        var count = Stopwatch.GetTimestamp();

        var advanced = clock.AtCount(count + 3600 * Stopwatch.Frequency) - clock.AtCount(count);

        var expected = TimeSpan.FromSeconds(3600) + new TimeSpan((long)Math.Round(3600e7 * skew));
        Assert.That(Math.Abs((advanced - expected).Ticks), Is.LessThanOrEqualTo(2));
    }

    [Test]
    public void Now_AtStart_IsTheEpoch()
    {
        var before = Stopwatch.GetTimestamp();
        var clock = new StopwatchControlClock(Epoch);
        var now = clock.Now;
        var took = Stopwatch.GetElapsedTime(before);

        Assert.That(now >= Epoch && now - Epoch <= took, Is.True, now.ToString());
    }

    [Test]
    public void AtCount_WithResolution_IsRoundedDown()
    {
        var clock = new StopwatchControlClock(new ControlTime(new TimeSpan(-12_345))) { Resolution = TimeSpan.FromMilliseconds(1) };
        var (interceptNs, _) = clock.OverMonotonicCounter;

        // Times before and after zero, which are not multiples of the resolution.
        for (var i = -20; i <= 20; i++)
        {
            var count = (long)((Int128)(i * 130_000L - interceptNs) * Stopwatch.Frequency / 1_000_000_000);
            var exactNs = interceptNs + (decimal)count / Stopwatch.Frequency * 1_000_000_000;
            var shownNs = clock.AtCount(count).Nanoseconds;
            Assert.That(shownNs % 1_000_000, Is.Zero, $"{exactNs} ns");
            Assert.That(exactNs - shownNs, Is.GreaterThanOrEqualTo(0).And.LessThan(1_000_000), $"{exactNs} ns");
        }
    }

    [TestCase(0)]
    [TestCase(250e-6)]
    [TestCase(-250e-6)]
    public void OverMonotonicCounter_AnyCount_EqualsTheClock(double skew)
    {
        var clock = new StopwatchControlClock(ControlTime.FromSeconds(1_700_000_000), skew);
        var (intercept, rate) = clock.OverMonotonicCounter;

        foreach (var seconds in new[] { 0L, 10, 86_400 })
        {
            var count = Stopwatch.GetTimestamp() + seconds * Stopwatch.Frequency;
            var counterNs = (decimal)count / Stopwatch.Frequency * 1_000_000_000;
            Assert.That(
                Math.Abs(intercept + (decimal)rate * counterNs - clock.AtCount(count).Nanoseconds), Is.LessThanOrEqualTo(200), $"after {seconds} s");
        }
    }
}
