using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Status;
using Nowpose.Gateway.Status.Cell;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class CellBoardFaultTests : CellBoardFixture
{
    [Test]
    public void Frames_Silent_HaveReasonAndStart()
    {
        var start = _time.GetUtcNow();
        _board.Add(_source, Pose("box", 5, "nowhere"), isStationary: false);
        _time.Advance(TimeSpan.FromSeconds(1.5));

        var frame = _board.Frames(At(6.5)).Single();

        Assert.That((frame.State, frame.Reason, frame.Since), Is.EqualTo(("stale", CellReasons.PosesStopped, start)));
    }

    [Test]
    public void Frames_SilentAtRest_HaveTheReasonOfTheAdapter()
    {
        _source.Name = "cell";
        _board.Add(_source, Pose("box", 5), isStationary: false);
        _time.Advance(TimeSpan.FromSeconds(1.5));
        _reports.Add("cell", [KeyValuePair.Create("frame/box", "rest 1700000000.000 assumed at rest")]);

        var frame = _board.Frames(At(6.5)).Single();

        Assert.That((frame.State, frame.Reason, frame.IsAtRest), Is.EqualTo(("stale", "assumed at rest", true)));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Frames_ReportedAtRestWithoutAPoseOfThisConnection_AreMissing(bool hasEarlierPose)
    {
        _source.Name = "cell";
        if (hasEarlierPose) _board.Add(_source, Pose("box", 5), isStationary: false);
        if (hasEarlierPose) _board.EndFrame("box");
        _time.Advance(TimeSpan.FromSeconds(1.5));

        _reports.Add("cell", [KeyValuePair.Create("frame/box", "rest 1700000000.000 assumed at rest")]);

        var frame = _board.Frames(At(6.5)).Single();
        Assert.That((frame.Name, frame.State, frame.Reason, frame.IsAtRest), Is.EqualTo(("box", "missing", CellReasons.NoPoseAtRest, false)));
        _board.Add(_source, Pose("box", 6), isStationary: false);
        Assert.That(_board.Frames(At(6.5)).Single().State, Is.EqualTo("live"));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void FramesAndSignals_SourceEnded_AreRemovedOnlyAfterANormalEnd(bool isNormal)
    {
        _board.Add(_source, Pose("box", 5), isStationary: false);
        _board.Add(_source, Pose("table", 5), isStationary: true);
        _board.Add(_source, new SignalsMessage(At(5), new SignalValue("grip", 1)));
        if (isNormal) _board.Leave(_source);
        _board.End(_source, ["grip"]);
        _time.Advance(JointBoard.ForgottenAfter);
        Assert.That(_board.Frames(At(600)).Count + _board.Signals(At(600)).Count, Is.EqualTo(3));

        _time.Advance(TimeSpan.FromSeconds(1));

        Assert.That(_board.Frames(At(601)).Select(frame => frame.Name), Is.EqualTo(isNormal ? new[] { "table" } : ["box", "table"]));
        Assert.That(_board.Signals(At(601)).Count, Is.EqualTo(isNormal ? 0 : 1));
    }

    [Test]
    public void Frames_ReportedInFault_HaveTheReasonUntilPosesArrive()
    {
        _source.Name = "cell";
        _board.Add(_source, Pose("box", 5), isStationary: false);
        _reports.Add("cell", [KeyValuePair.Create("frame/box", "fault 1700000000.000 node deleted"), KeyValuePair.Create("frame/lid", "missing 1700000000.000 no value")]);

        Assert.That(_board.Frames(At(5)).Select(frame => (frame.Name, frame.State, frame.Reason)), Is.EqualTo(new[]
        {
            ("box", "live", null), ("lid", "missing", "no value"),
        }), "a pose that arrives is not in fault");

        _time.Advance(TimeSpan.FromSeconds(1.5));

        Assert.That(_board.Frames(At(7)).Select(frame => (frame.Name, frame.State, frame.Reason, frame.AgeS)), Is.EqualTo(new (string, string, string, double?)[]
        {
            ("box", "fault", "node deleted", 2), ("lid", "missing", "no value", null),
        }));

        _time.Advance(TimeSpan.FromMinutes(1));

        Assert.That(_board.Frames(At(68)).Select(frame => frame.State), Is.EqualTo(new[] { "fault", "missing" }), "nothing shows that the fault has ended");
    }

    [Test]
    public void FramesAndSignals_ReportedInFault_AreInFaultUntilTheConnectionOfTheAdapterEnds()
    {
        _source.Name = "cell";
        _board.Add(_source, Pose("box", 5), isStationary: false);
        _board.Add(_source, new SignalsMessage(At(5), new SignalValue("grip", 1)));
        _reports.Add("cell", [.. new[] { "frame/box", "frame/lid", "signal/grip", "signal/lamp" }.Select(key => KeyValuePair.Create(key, "fault 1700000000.000 gone"))], _source);
        _time.Advance(TimeSpan.FromMinutes(1));

        Assert.That(_board.Frames(At(65)).Select(frame => frame.State).Concat(_board.Signals(At(65)).Select(signal => signal.State)), Has.Exactly(4).EqualTo("fault"));
        Assert.That(_board.FaultySignals(At(65)).Select(one => one.Name), Is.EqualTo(new[] { "grip", "lamp" }));

        _source.Dispose();
        _board.End(_source, ["grip"]);

        Assert.That(_board.Frames(At(65)).Select(frame => (frame.Name, frame.State)), Is.EqualTo(new[] { ("box", "stale") }));
        Assert.That(_board.Signals(At(65)).Select(signal => (signal.Name, signal.State)), Is.EqualTo(new[] { ("grip", "ended") }));
        Assert.That(_board.FaultySignals(At(65)), Is.Empty);
    }

    [TestCase("live 1700000000.000")]
    [TestCase("rest 1700000000.000 unchanged")]
    public void Signals_AdapterStopsReporting_AreStaleSinceItsLastReport(string report)
    {
        void Report() => _reports.Add("cell", [KeyValuePair.Create("signal/grip", report), KeyValuePair.Create("signal/other", report)], _source);
        _source.Name = "cell";
        _board.Add(_source, new SignalsMessage(At(5), new SignalValue("grip", 1)));
        _board.Add(new MessageHub().OpenSource(), new SignalsMessage(At(5), new SignalValue("other", 1)));
        Report();
        var last = _time.GetUtcNow();
        (string, string, DateTimeOffset?)[] Faulty() =>
            [.. _board.Signals(At(8)).Where(signal => signal.State != "live").Select(signal => (signal.Name, signal.State, signal.Since))];

        _time.Advance(AdapterReport.Validity - TimeSpan.FromMilliseconds(1));
        Assert.That(Faulty(), Is.Empty);
        _time.Advance(TimeSpan.FromMilliseconds(1));

        Assert.That(Faulty(), Is.EqualTo(new (string, string, DateTimeOffset?)[] { ("grip", "stale", last) }), "only the signal of this adapter");
        Assert.That(_board.Signals(At(8)).First().Reason, Is.EqualTo(CellReasons.AdapterSilent));
        Assert.That(_board.FaultySignals(At(65)).Select(one => (one.Name, one.Report.State)), Is.EqualTo(new[] { ("grip", JointDataState.Stale) }));

        Report();

        Assert.That(Faulty(), Is.Empty);
        Assert.That(_board.FaultySignals(At(65)), Is.Empty);
    }

    [Test]
    public void Signals_ReportedInFaultByTheirSource_AreNotLive()
    {
        _source.Name = "cell";
        _board.Add(_source, new SignalsMessage(At(5), new SignalValue("grip", 1)));
        _reports.Add("other", [KeyValuePair.Create("signal/grip", "missing 1700000000.000 no value")]);
        Assert.That(_board.Signals(At(5)).Single().State, Is.EqualTo("live"), "another adapter does not publish this signal");

        _reports.Add("other", []);
        _reports.Add("cell", [KeyValuePair.Create("signal/grip", "refused 1700000000.000 BadSensorFailure"), KeyValuePair.Create("signal/lamp", "missing 1700000000.000 no value")]);

        Assert.That(_board.Signals(At(6)), Is.EqualTo(new[]
        {
            new SignalView("grip", 1, "cell", "refused", 1, "BadSensorFailure") { Since = DateTimeOffset.FromUnixTimeSeconds(1_700_000_000) },
            new SignalView("lamp", null, "cell", "missing", null, "no value") { Since = DateTimeOffset.FromUnixTimeSeconds(1_700_000_000) },
        }));
    }

    [Test]
    public void Reports_WithTransmissionTimesAndAWrongClock_HaveOneStartOnTheClockOfTheGateway()
    {
        var sent = ControlTime.FromSeconds(1_000_000);
        var since = _time.GetUtcNow() - TimeSpan.FromSeconds(10);
        foreach (var delay in new[] { 0, 0.2, 0.05 })
        {
            _time.Advance(TimeSpan.FromSeconds(delay));
            _reports.Add("cell", [KeyValuePair.Create("signal/grip", "fault 999990.000 gone")], sent: sent);
            Assert.That(_reports.Troubled("signal/").Single().Report.Since, Is.EqualTo(since));
        }
    }

    [Test]
    public void Reports_FromManyAdaptersWithManyNames_AreBounded()
    {
        for (var adapter = 0; adapter < 100; adapter++)
            _reports.Add($"a{adapter}", [.. Enumerable.Range(0, 1000).Select(i => KeyValuePair.Create($"frame/{adapter}-{i}", "fault 1700000000.000 gone"))]);
        _reports.Add("damaged", [KeyValuePair.Create("frame/x", "gone"), KeyValuePair.Create("frame/y", "stale 1 x")]);

        var troubled = _reports.Troubled("frame/");

        Assert.That(troubled, Has.Count.EqualTo(CellReports.MaxAdapters * ProtocolLimits.Frames));
        Assert.That(troubled.Select(one => one.Adapter), Has.None.EqualTo("damaged"));
    }

    [Test]
    public void Reports_AdaptersWithoutFramesAndSignals_DoNotCountTowardsTheLimit()
    {
        for (var i = 0; i < CellReports.MaxAdapters; i++) _reports.Add($"arm{i}", [KeyValuePair.Create("joint/a", "live 1700000000.000")]);
        for (var i = 0; i < CellReports.MaxAdapters; i++) _reports.Add($"cell{i}", [KeyValuePair.Create($"signal/s{i}", "fault 1700000000.000 gone")]);

        Assert.That(_reports.Troubled("signal/"), Has.Count.EqualTo(CellReports.MaxAdapters));
    }

    [Test]
    public void Reports_MoreAdaptersThanTheLimit_AreIgnoredAndLoggedOnce()
    {
        var log = new List<string>();
        var reports = new CellReports(_time, log.Add);
        void Add(int adapter) => reports.Add($"a{adapter}", [KeyValuePair.Create("signal/s", "fault 1700000000.000 gone")]);
        for (var i = 0; i < CellReports.MaxAdapters; i++) Add(i);
        Assert.That(log, Is.Empty);

        for (var i = 0; i < 3; i++) Add(CellReports.MaxAdapters);

        Assert.That(log, Is.EqualTo(new[] { AdapterMessages.TooMany($"a{CellReports.MaxAdapters}", CellReports.MaxAdapters) }));

        reports.Add("a0", []);
        Add(CellReports.MaxAdapters);

        Assert.That(reports.Troubled("signal/").Select(one => one.Adapter), Has.None.EqualTo("a0").And.Some.EqualTo($"a{CellReports.MaxAdapters}"));
    }
}
