using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Clock;

/// <summary>Tests sources whose time stamps are on the gateway's own clock or on the system clock, in virtual time.</summary>
public class StampWatchTests : StampWatchFixture
{
    [TestCase(3600.0)]
    [TestCase(-3600.0)]
    [TestCase(2.0)]
    [TestCase(0.3)]
    [TestCase(-1.5)]
    public void Look_SystemClockCorrectedAndSourcesFollow_ReportsAContradictionWithARemedy(double seconds)
    {
        Run(5, () => System);
        Assert.That(_watch.Warning, Is.Null);

        _correction = TimeSpan.FromSeconds(seconds);
        Run(5, () => System);

        Assert.That(_watch.IsContradicted, Is.True);
        Assert.That(_watch.Found.Reason, Does.EndWith(StampMessages.FitsSystemClock));
        Assert.That(_watch.Found.Remedy, Is.EqualTo(StampMessages.SystemRemedy));
        Assert.That(_log, Has.Count.LessThanOrEqualTo(2), "the correction and the contradiction are logged once each");
    }

    [TestCase(-0.11, "110 ms", true)]
    [TestCase(-0.2, "200 ms", true)]
    [TestCase(-0.6, "600 ms", true)]
    [TestCase(-0.9, "900 ms", true)]
    [TestCase(0.11, "110 ms", false)]
    public void Look_SmallCorrectionAndOneSourceFollows_ReportsAContradictionOfThatSource(double seconds, string length, bool isOlder)
    {
        var withoutCorrection = () => _own.Now;
        Run(StampWatch.Seconds + 1, () => System, withoutCorrection);
        Assert.That(_watch.Warning, Is.Null);

        _correction = TimeSpan.FromSeconds(seconds);
        Run(2, () => System, withoutCorrection);

        Assert.That(_watch.IsContradicted, Is.True);
        Assert.That(_watch.Found.Reason, Is.EqualTo(StampMessages.Shifted("first", length, isOlder, false, StampMessages.Corrected)));
        Assert.That(_watch.Found.Remedy, Is.EqualTo(StampMessages.SystemRemedy));
        Run(60, () => System, withoutCorrection);
        Assert.That(_watch.IsContradicted, Is.True, "the contradiction lasts");

        _correction = TimeSpan.Zero;
        Run(1, () => System, withoutCorrection);
        Assert.That(_watch.IsContradicted, Is.False, "the system clock has its earlier time again");
    }

    static readonly object[][] Uncorrected =
    [
        [-0.11, StampMessages.Shifted("first", "110 ms", isOlder: false, true, StampMessages.NotCorrected)],
        [-0.3, Implausible("230 ms", isFuture: true)],
        [0.11, StampMessages.Shifted("first", "110 ms", isOlder: true, true, StampMessages.NotCorrected)],
        [0.9, StampMessages.Shifted("first", "900 ms", isOlder: true, true, StampMessages.NotCorrected)],
        [2.5, Implausible("2.6 s", isFuture: false)],
        [-3600.0, Implausible("60.0 minutes", isFuture: true)],
    ];

    static string Implausible(string length, bool isFuture) =>
        StampMessages.Implausible("first", 100, length, isFuture) + ": " + StampMessages.NotCorrected;

    [TestCaseSource(nameof(Uncorrected))]
    public void Look_ServedSystemClockCorrectedButNotTheSource_ReportsAContradictionOfTheSource(double seconds, string expected)
    {
        var clock = new SystemControlClock(_time);
        var watch = new ServedClock(clock, new VirtualPlant().Clocks, _time).Stamps;
        var uncorrected = TimeSpan.Zero;
        var withoutCorrection = () => clock.Now - uncorrected;
        Run(watch, clock, StampWatch.Seconds + 1, withoutCorrection, () => clock.Now);
        Assert.That(watch.Warning, Is.Null);

        uncorrected = TimeSpan.FromSeconds(seconds);
        _time.Correct(uncorrected);
        Run(watch, clock, StampWatch.Seconds, withoutCorrection, () => clock.Now);

        Assert.That(watch.IsContradicted, Is.True);
        Assert.That(watch.Found.Reason, Is.EqualTo(expected));
        Assert.That(watch.Found.Remedy, Is.EqualTo(StampMessages.SourceRemedy));

        Run(watch, clock, StampWatch.Seconds + 1, () => clock.Now, () => clock.Now);
        Assert.That(watch.Warning, Is.Null, "the source follows now");
    }

    [Test]
    public void Look_SourceReconnectsAfterASmallCorrection_IsComparedWithItsEarlierTimeStamps()
    {
        Run(StampWatch.Seconds + 1, () => System);
        Run(StampWatch.Seconds + 1);

        _correction = TimeSpan.FromSeconds(-0.2);
        _sources[0] = Open(new MessageHub(), _sources[0].Name);
        Run(2, () => System);

        Assert.That(_watch.IsContradicted, Is.True);
    }

    [TestCase(0.3)]
    [TestCase(-0.04)]
    public void Look_PlantClockIsServed_WarnsOnlyAfterItIsSet(double seconds)
    {
        Run(StampWatch.Seconds + 1, () => System);

        (_isOwnServed, _plantAhead) = (false, TimeSpan.FromSeconds(seconds));
        Run(StampWatch.Seconds + 2, () => System);
        Assert.That(_watch.Warning, Is.Null, "the served clock has changed, but is correct");

        _plantAhead += TimeSpan.FromSeconds(0.3);
        Run(2, () => System);
        Assert.That(_watch.Found.Reason, Is.EqualTo(
            StampMessages.Shifted("first", "300 ms", isOlder: true, false, StampMessages.NotFollowing("plc"))));
        Assert.That(_watch.Found.Remedy, Is.EqualTo(StampMessages.SourceRemedy));

        (_isOwnServed, _plantAhead) = (true, TimeSpan.Zero);
        Run(StampWatch.Seconds + 2, () => System);
        Assert.That(_watch.Warning, Is.Null, "the gateway serves its own clock again");
    }

    [Test]
    public void Look_SamplesBecomeLaterWithoutACorrection_ReportsNoContradiction()
    {
        Run(StampWatch.Seconds + 1, () => System);
        Run(60, () => System - TimeSpan.FromSeconds(0.4));

        Assert.That(_watch.Warning, Is.Null);
    }

    [Test]
    public void Look_SystemClockCorrectedButSourcesUseTheGatewaysClock_GivesOnlyAWarning()
    {
        Run(5, () => _own.Now);

        _correction = TimeSpan.FromSeconds(-42);
        Run(60, () => _own.Now);

        Assert.That(_watch.IsContradicted, Is.False);
        Assert.That(_watch.Found.Reason, Is.EqualTo(StampMessages.SystemClockCorrected(-42)));
        Assert.That(_log, Has.Count.EqualTo(1));
    }

    // On Windows, the counter of the gateway's own clock does not follow the system clock: it has another rate for as long as the gateway runs.
    [Test]
    public void Look_OwnClockHasAnotherRateForADay_LogsEachDoublingOfTheDifference()
    {
        var minute = TimeSpan.FromMinutes(1);
        for (var i = 0; i < 24 * 60; i++)
        {
            _time.Advance(minute);
            _correction += minute * 30e-6;
            _watch.Look(_log.Add);
        }

        var logged = _log.Select(line => MessageNumbers.In(line, StampMessages.SystemClockCorrected(1))[0]).ToArray();
        Assert.That(logged, Is.EqualTo(new[] { 0.1, 0.2, 0.4, 0.8, 1.6 }).Within(0.01));
    }

    [Test]
    public void Look_SystemClockCorrectedBack_EndsTheContradiction()
    {
        _correction = TimeSpan.FromSeconds(10);
        Run(5, () => System);

        _correction = TimeSpan.Zero;
        Run(StampWatch.Seconds + 1, () => System);

        Assert.That((_watch.IsContradicted, _watch.Warning), Is.EqualTo((false, (string)null)));
        Assert.That(_log, Has.Count.EqualTo(2));
    }

    [Test]
    public void Look_SourceClockAhead_ReportsTheSource()
    {
        _isOwnServed = false;
        Run(5, () => _own.Now + TimeSpan.FromSeconds(5));

        Assert.That(_watch.IsContradicted, Is.True);
        Assert.That(_watch.Found.Reason, Is.EqualTo(StampMessages.Implausible("first", 100, "4.9 s", isFuture: true)));
        Assert.That(_watch.Found.Remedy, Is.EqualTo(StampMessages.SourceRemedy));
    }

    [Test]
    public void Look_OwnClockWithADifferentRate_GivesNoWarning()
    {
        _own.Skew = 100e-6;
        for (var i = 0; i < 3600; i++)
        {
            // The system clock loses 100 µs per second relative to the gateway's own clock.
            _correction = TimeSpan.FromSeconds(-100e-6 * i);
            Run(1);
        }

        Assert.That(_watch.Warning, Is.Null);
    }
}
