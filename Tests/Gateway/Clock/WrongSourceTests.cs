using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Clock;

public class WrongSourceTests : StampWatchFixture
{
    [TestCase(755.0, "12.6 minutes")]
    [TestCase(-36_000.0, "10.0 hours")]
    [TestCase(1_795_288_273.0, "20779 days")]
    public void Look_TimeStampsFarFromTheControlClock_ReportsTheDifferenceInAReadableUnit(double seconds, string length)
    {
        _isOwnServed = false;
        _correction = TimeSpan.FromSeconds(seconds);
        Run(5, () => System);

        Assert.That(_watch.Found.Reason, Is.EqualTo(StampMessages.Implausible("first", 100, length, seconds > 0)));
    }

    [TestCase(0.3, "230 ms")]
    [TestCase(0.5, "430 ms")]
    public void Look_AcceptedTimeStampsAheadForFiveSeconds_ReportsTheSourceAndTheDifference(double seconds, string by)
    {
        var ahead = TimeSpan.FromSeconds(seconds);
        Run(StampWatch.Seconds - 1, () => System, () => System + ahead);
        Assert.That(_watch.Ahead, Is.Empty, "the condition has not lasted long enough");

        Run(2, () => System, () => System + ahead);
        Assert.That(_watch.Ahead, Is.EqualTo(new[] { ("second", by) }));
        Assert.That(_watch.IsContradicted, Is.False, "stamps that are slightly ahead do not contradict the clock");

        Run(StampWatch.Seconds, () => System, () => System);
        Assert.That(_watch.Ahead, Is.Empty, "the clock of the source was set");
    }

    [TestCase(1.2, "1.3 s")]
    [TestCase(5.0, "5.1 s")]
    public void Look_TimeStampsTooOldForFiveSeconds_ReportsTheSourceAndTheDifference(double seconds, string by)
    {
        var behind = TimeSpan.FromSeconds(seconds);
        Run(StampWatch.Seconds - 1, () => System, () => System - behind);
        Assert.That(_watch.Behind, Is.Empty, "the condition has not lasted long enough");

        Run(2, () => System, () => System - behind);
        Assert.That(_watch.Behind, Is.EqualTo(new[] { ("second", by) }));
        Assert.That((_watch.Ahead.Count, _watch.IsContradicted), Is.EqualTo((0, false)), "samples that arrive late do not contradict the clock");

        Run(StampWatch.Seconds, () => System, () => System);
        Assert.That(_watch.Behind, Is.Empty, "the clock of the source was set");
    }

    [Test]
    public void Look_TimeStampsTooOldAfterOneInTheFuture_ReportsTheSource()
    {
        Run(1, () => System + TimeSpan.FromHours(1));

        Run(2 * StampWatch.Seconds, () => System - TimeSpan.FromSeconds(5));

        Assert.That(_watch.Behind, Has.Count.EqualTo(1));
    }

    [Test]
    public void Look_TwoStreamsOfASourceTooOld_ReportsTheSource()
    {
        var isFirst = false;
        Run(2 * StampWatch.Seconds, () => System - TimeSpan.FromSeconds((isFirst = !isFirst) ? 3 : 7));

        Assert.That(_watch.Behind, Has.Count.EqualTo(1));
    }

    [Test]
    public void Look_OldSampleRepeated_ReportsNoSource()
    {
        var stamp = System;
        Run(20, () => stamp);

        Assert.That(_watch.Behind, Is.Empty);
    }

    [Test]
    public void Look_SamplesOfAPauseArriveAtOnce_ReportsNoSource()
    {
        Run(10, () => System);
        for (var i = 0; i < 44; i++)
        {
            _time.Advance(Second / 10);
            if (i % 10 == 9) _watch.Look(_log.Add);
        }

        for (var i = 44; i >= 0; i--) _watch.Add(_sources[0], System - Acquisition - i * Second / 10, false);
        for (var i = 0; i < 3 * StampWatch.Seconds; i++)
        {
            _watch.Look(_log.Add);
            Assert.That(_watch.Behind, Is.Empty);
            Run(1, () => System);
        }
    }

    [TestCase(0.9, 0.0)]
    [TestCase(2.5, 2.0)]
    public void Look_TimeStampsOlderByLessThanOneSecondAndTheErrorBound_ReportsNoSource(double seconds, double errorBound)
    {
        _errorBound = TimeSpan.FromSeconds(errorBound);
        Run(10, () => System - TimeSpan.FromSeconds(seconds));

        Assert.That(_watch.Behind, Is.Empty);
    }

    [TestCase(0.078, 0.002, "8 ms")]
    [TestCase(0.15, 0.002, "80 ms")]
    [TestCase(0.7, 0.1, "630 ms")]
    public void Look_TimeStampsAheadOfTheClockThatTheSourceOffers_ReportsTheSource(double seconds, double bound, string by)
    {
        (_isOwnServed, _offeredBound) = (false, TimeSpan.FromSeconds(bound));
        Run(StampWatch.Seconds + 2, () => _own.Now + TimeSpan.FromSeconds(seconds));

        Assert.That(_watch.Ahead, Is.EqualTo(new[] { ("first", by) }));
        Assert.That(_watch.IsContradicted, Is.False);
    }

    [TestCase(0.072, 0.0)]
    [TestCase(0.09, 0.02)]
    [TestCase(-0.3, 0.0)]
    public void Look_TimeStampsWithinTheErrorOfTheClockThatTheSourceOffers_ReportsNoSource(double seconds, double bound)
    {
        (_isOwnServed, _offeredBound) = (false, TimeSpan.FromSeconds(bound));
        Run(StampWatch.Seconds + 2, () => _own.Now + TimeSpan.FromSeconds(seconds));
        _correction = TimeSpan.FromSeconds(0.3);
        Run(StampWatch.Seconds + 2, () => _own.Now + TimeSpan.FromSeconds(seconds));

        Assert.That((_watch.Ahead.Count, _watch.Warning), Is.EqualTo((0, (string)null)));
    }

    [TestCase(7200, "local time")]
    [TestCase(-18_000.5, "local time")]
    [TestCase(20_701, "local time")]
    [TestCase(37.2, "TAI")]
    [TestCase(18, "GPS time")]
    [TestCase(-37, null)]
    [TestCase(905, null)]
    [TestCase(86_400, null)]
    public void Look_TimeStampsOfAnotherTimeScale_NamesTheProbableCause(double seconds, string cause)
    {
        (_isOwnServed, _correction) = (false, TimeSpan.FromSeconds(seconds));
        Run(5, () => System);

        Assert.That(_watch.Found.Remedy, Does.StartWith(StampMessages.SourceRemedy));
        Assert.That(_watch.Found.Remedy, cause == null ? Is.EqualTo(StampMessages.SourceRemedy) : Does.Contain($" {cause} "));
    }

    [TestCase(0.1, 0.0)]
    [TestCase(0.3, 0.2)]
    public void Look_TimeStampsAheadWithinTheErrorsOfTheClocks_ReportsNoSource(double seconds, double errorBound)
    {
        _errorBound = TimeSpan.FromSeconds(errorBound);
        Run(10, () => System + TimeSpan.FromSeconds(seconds));

        Assert.That(_watch.Ahead, Is.Empty);
    }

    [Test]
    public void Look_TimeStampsDiverge_ReportsTheNewestDifference()
    {
        _isOwnServed = false;
        for (var seconds = 10; seconds < 20; seconds++)
        {
            var ahead = TimeSpan.FromSeconds(seconds);
            Run(1, () => _own.Now + ahead);
            if (seconds >= 12) Assert.That(_watch.Found.Reason, Does.Contain($" {seconds - 1}.9 s "));
        }
    }

    [Test]
    public void Look_OneOfThreeSourcesIsWrong_ReportsThatSource()
    {
        Run(5, () => System, () => System, () => System + TimeSpan.FromSeconds(5));

        Assert.That(_watch.IsContradicted, Is.True);
        Assert.That(_watch.Found.Reason, Does.StartWith(StampMessages.Implausible("third", 100, "4.9 s", isFuture: true)).And.Not.Contain("first"));
    }

    [Test]
    public void Look_TwoOfThreeSourcesAreWrong_ReportsBoth()
    {
        Run(5, () => System, () => _own.Now, () => System);
        _correction = TimeSpan.FromHours(1);
        Run(StampWatch.Seconds, () => System, () => _own.Now, () => System);

        Assert.That(_watch.Found.Reason, Does.Contain("first").And.EndWith(StampMessages.SameFor(["third"])));
    }

    [Test]
    public void Look_WrongSourceStops_IsNoLongerReported()
    {
        Run(5, () => System + TimeSpan.FromSeconds(5));
        Assert.That(_watch.IsContradicted, Is.True);

        Run(StampWatch.Seconds + 1);

        Assert.That(_watch.IsContradicted, Is.False);
    }
}
