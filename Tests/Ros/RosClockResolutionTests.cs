using Nowpose.Network;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Ros;

public class RosClockResolutionTests
{
    static TimeSpan Ms(double ms) => TimeSpan.FromTicks((long)(ms * TimeSpan.TicksPerMillisecond));

    static TimeSpan Floored(TimeSpan at, double stepMs) => new(at.Ticks / Ms(stepMs).Ticks * Ms(stepMs).Ticks);

    // Sends requests at the intervals of RosTimeExchanges: 3 ms after a response during a measurement, otherwise after a pause. A response takes 2
    // ms.
    static void Ask(RosClockResolution resolution, double fromSeconds, double toSeconds, Func<TimeSpan, TimeSpan> shown, double pauseMs = 1000)
    {
        for (var at = TimeSpan.FromSeconds(fromSeconds); at < TimeSpan.FromSeconds(toSeconds);)
        {
            resolution.Add(new ControlTime(shown(at + Ms(1))), new HeadsetTime(at), new HeadsetTime(at + Ms(2)));
            at += Ms(resolution.IsMeasuring && !resolution.IsStopped ? 5 : pauseMs);
        }
    }

    static RosClockResolution Asked(double seconds, Func<TimeSpan, TimeSpan> shown)
    {
        var resolution = new RosClockResolution();
        Ask(resolution, 100, 100 + seconds, shown);
        return resolution;
    }

    [TestCase(1)]
    [TestCase(4)]
    [TestCase(10)]
    public void Value_SimulatedClockWithSteps_EqualsTheStep(double stepMs)
    {
        var resolution = Asked(5, at => Floored(at, stepMs));

        Assert.That(resolution.IsKnown, Is.True);
        Assert.That(resolution.Value, Is.EqualTo(Ms(stepMs)));
    }

    [Test]
    public void Value_SystemClock_IsAtMostAMicrosecond()
    {
        var random = new Random(7);

        var resolution = Asked(5, at => at + new TimeSpan(random.Next(1000)));

        Assert.That(resolution.Value, Is.LessThanOrEqualTo(new TimeSpan(10)));
    }

    [TestCase(16)]
    [TestCase(100)]
    [TestCase(250)]
    public void Value_RarelyPublishedClock_EqualsTheIntervalOfItsMessages(double everyMs)
    {
        // The clock shows whole milliseconds.
        var resolution = Asked(5, at => Floored(at, everyMs) + Ms(3));

        Assert.That(resolution.Value, Is.EqualTo(Ms(everyMs)));
    }

    [Test]
    public void Value_RareUpdatesAndRequests_StaysConstant()
    {
        var resolution = new RosClockResolution();
        for (var second = 100; second < 700; second++)
        {
            Ask(resolution, second, second + 1, at => Floored(at, 16) + Ms(3));
            Assert.That(resolution.Value, Is.EqualTo(Ms(16)), $"after {second - 100} s");
        }
    }

    [Test]
    public void Value_BriefStandstill_HasNoEffectAfterTwoMeasurements()
    {
        var resolution = new RosClockResolution();
        static TimeSpan Shown(TimeSpan at) => at.TotalSeconds is > 110 and < 110.5 ? TimeSpan.FromSeconds(110) : Floored(at, 1);
        Ask(resolution, 100, 112, Shown, pauseMs: 100);
        var soonAfter = resolution.Value;
        Ask(resolution, 112, 170, Shown, pauseMs: 100);

        Assert.That(soonAfter, Is.GreaterThan(Ms(300)).And.LessThan(Ms(700)));
        Assert.That(resolution.Value, Is.EqualTo(Ms(1)));
    }

    [Test]
    public void IsKnown_FewAnswersOrFewSteps_IsFalse()
    {
        Assert.That(Asked(0.07, at => at).IsKnown, Is.False, "15 answers");
        Assert.That(Asked(0.3, at => Floored(at, 400)).IsKnown, Is.False, "one change at most");
    }

    [Test]
    public void IsStopped_SimulationPaused_IsTrueAndKeepsTheResolution()
    {
        var resolution = new RosClockResolution();
        static TimeSpan Shown(TimeSpan at) => at.TotalSeconds is > 105 and < 115 ? TimeSpan.FromSeconds(105) : Floored(at, 1);
        Ask(resolution, 100, 114.9, Shown, pauseMs: 200);
        var isStopped = resolution.IsStopped;
        Ask(resolution, 115, 117, Shown, pauseMs: 200);

        Assert.That(isStopped, Is.True);
        Assert.That(resolution.IsStopped, Is.False);
        Assert.That(resolution.Value, Is.EqualTo(Ms(1)));
    }
}
