using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Clock;

/// <summary>Tests sources whose time stamps are on the gateway's own clock or on the system clock, in virtual time.</summary>
public class StampWatchTests
{
    static readonly TimeSpan Second = TimeSpan.FromSeconds(1);
    static readonly TimeSpan Acquisition = TimeSpan.FromMilliseconds(70);

    readonly List<string> _log = [];
    readonly OwnClock _own = new();
    HubSource[] _sources;
    SteppedTime _time;
    StampWatch _watch;
    TimeSpan _correction;
    TimeSpan _errorBound;
    TimeSpan _plantAhead;
    bool _isOwnServed;

    ControlTime System => _own.Now + _correction;

    [SetUp]
    public void SetUp()
    {
        (_time, _correction, _errorBound, _isOwnServed) = (new SteppedTime(), TimeSpan.Zero, TimeSpan.Zero, true);
        _own.Time = _time;
        var hub = new MessageHub();
        _sources = [.. new[] { "first", "second", "third" }.Select(name => Open(hub, name))];
        _log.Clear();
        _plantAhead = TimeSpan.Zero;
        _watch = new StampWatch(
            () => _own.Now + _plantAhead, () => _isOwnServed ? "own" : "plc", () => _errorBound, () => _isOwnServed ? _own : null, () => System, false, _time);
        _watch.Look(_log.Add);
    }

    static HubSource Open(MessageHub hub, string name)
    {
        var source = hub.OpenSource();
        source.Name = name;
        return source;
    }

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
        Assert.That(_watch.Warning, Does.Contain("match the system clock").And.Contain("--own-clock system"));
        Assert.That(_log, Has.Count.LessThanOrEqualTo(2), "the correction and the contradiction are logged once each");
    }

    [TestCase(-0.11, "110 ms older")]
    [TestCase(-0.2, "200 ms older")]
    [TestCase(-0.6, "600 ms older")]
    [TestCase(-0.9, "900 ms older")]
    [TestCase(0.11, "110 ms newer")]
    public void Look_SmallCorrectionAndOneSourceFollows_ReportsAContradictionOfThatSource(double seconds, string expected)
    {
        var withoutCorrection = () => _own.Now;
        Run(StampWatch.Seconds + 1, () => System, withoutCorrection);
        Assert.That(_watch.Warning, Is.Null);

        _correction = TimeSpan.FromSeconds(seconds);
        Run(2, () => System, withoutCorrection);

        Assert.That(_watch.IsContradicted, Is.True);
        Assert.That(_watch.Found.Reason, Does.Contain("source first").And.Contain(expected).And.Not.Contain("second"));
        Assert.That(_watch.Found.Remedy, Does.Contain("--own-clock system"));
        Run(60, () => System, withoutCorrection);
        Assert.That(_watch.IsContradicted, Is.True, "the contradiction lasts");

        _correction = TimeSpan.Zero;
        Run(1, () => System, withoutCorrection);
        Assert.That(_watch.IsContradicted, Is.False, "the system clock has its earlier time again");
    }

    [TestCase(-0.11, "110 ms newer")]
    [TestCase(-0.3, "230 ms ahead of the control clock")]
    [TestCase(0.11, "110 ms older")]
    [TestCase(0.9, "900 ms older")]
    [TestCase(2.5, "2.6 s behind the control clock")]
    [TestCase(-3600.0, "60.0 minutes ahead of the control clock")]
    public void Look_ServedSystemClockCorrectedButNotTheSource_ReportsAContradictionOfTheSource(double seconds, string expected)
    {
        var clock = new SystemControlClock(_time);
        var watch = new ServedClock(clock, new ServedClockTests.VirtualPlant().Clocks, _time).Stamps;
        var uncorrected = TimeSpan.Zero;
        var withoutCorrection = () => clock.Now - uncorrected;
        Run(watch, clock, StampWatch.Seconds + 1, withoutCorrection, () => clock.Now);
        Assert.That(watch.Warning, Is.Null);

        uncorrected = TimeSpan.FromSeconds(seconds);
        _time.Correct(uncorrected);
        Run(watch, clock, StampWatch.Seconds, withoutCorrection, () => clock.Now);

        Assert.That(watch.IsContradicted, Is.True);
        Assert.That(watch.Found.Reason, Does.Contain("source first").And.Contain(expected).And.Contain("did not follow").And.Not.Contain("second"));
        Assert.That(watch.Found.Remedy, Does.StartWith("Set the clock of the source"));

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
        Assert.That(_watch.Found.Reason, Does.Contain("source first").And.Contain("300 ms older").And.Contain("plc").And.Not.Contain("correction"));
        Assert.That(_watch.Found.Remedy, Does.StartWith("Set the clock of the source").And.Not.Contain("--own-clock"));

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
        Assert.That(_watch.Warning, Does.Contain("corrected by -42.0 s"));
        Assert.That(_log, Has.Count.EqualTo(1));
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
        Assert.That(_watch.Warning, Does.Contain("100 %").And.Contain("4.9 s ahead of the control clock"));
        Assert.That(_watch.Found.Reason, Does.Contain("source first"));
        Assert.That(_watch.Found.Remedy, Is.EqualTo("Set the clock of the source, or let its adapter offer that clock."));
    }

    [TestCase(755.0, "are 12.6 minutes ")]
    [TestCase(-36_000.0, "are 10.0 hours ")]
    [TestCase(1_795_288_273.0, "are 20779 days ")]
    public void Look_TimeStampsFarFromTheControlClock_ReportsTheDifferenceInAReadableUnit(double seconds, string expected)
    {
        _isOwnServed = false;
        _correction = TimeSpan.FromSeconds(seconds);
        Run(5, () => System);

        Assert.That(_watch.Warning, Does.Contain(expected));
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
            if (seconds >= 12) Assert.That(_watch.Warning, Does.Contain($"are {seconds - 1}.9 s ahead"));
        }
    }

    [Test]
    public void Look_OneOfThreeSourcesIsWrong_ReportsThatSource()
    {
        Run(5, () => System, () => System, () => System + TimeSpan.FromSeconds(5));

        Assert.That(_watch.IsContradicted, Is.True);
        Assert.That(_watch.Found.Reason, Does.StartWith("100 % of the samples of the source third have stamps").And.Not.Contain("first"));
    }

    [Test]
    public void Look_TwoOfThreeSourcesAreWrong_ReportsBoth()
    {
        Run(5, () => System, () => _own.Now, () => System);
        _correction = TimeSpan.FromHours(1);
        Run(StampWatch.Seconds, () => System, () => _own.Now, () => System);

        Assert.That(_watch.Found.Reason, Does.Contain("source first").And.EndWith("; the same is true of third"));
    }

    [Test]
    public void Look_WrongSourceStops_IsNoLongerReported()
    {
        Run(5, () => System + TimeSpan.FromSeconds(5));
        Assert.That(_watch.IsContradicted, Is.True);

        Run(StampWatch.Seconds + 1);

        Assert.That(_watch.IsContradicted, Is.False);
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

    void Run(int seconds, params Func<ControlTime>[] sources) => Run(_watch, _own, seconds, sources);

    // Adds ten samples per second from each source, and checks the time stamps once per second.
    void Run(StampWatch watch, IControlClock control, int seconds, params Func<ControlTime>[] sources)
    {
        for (var i = 0; i < seconds * 10; i++)
        {
            _time.Advance(Second / 10);
            foreach (var (source, name) in sources.Zip(_sources))
            {
                var stamp = source() - Acquisition;
                watch.Add(name, stamp, stamp > control.Now + Second);
            }

            if (i % 10 == 9) watch.Look(_log.Add);
        }
    }

    sealed class OwnClock : IControlClock
    {
        public TimeProvider Time { get; set; }
        public double Skew { get; set; }
        public ControlTime Now => ControlTime.FromSeconds(1e9 + Time.GetElapsedTime(0).TotalSeconds);
    }
}
