using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Status;
using Nowpose.Gateway.Status.Cell;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class CellBoardTests
{
    readonly SteppedTime _time = new();
    CellReports _reports;
    CellBoard _board;
    HubSource _source;

    [SetUp]
    public void Start()
    {
        _reports = new CellReports(_time);
        _board = new CellBoard(_time, _reports, link => link == "tool0");
        _source = new MessageHub().OpenSource();
    }

    static ControlTime At(double seconds) => ControlTime.FromSeconds(seconds);

    static TransformsMessage Pose(string child, double t, string parent = "world") => new(new FrameTransform(At(t), parent, child, 1, 2, 3, 0, 0, 0, 1));

    [Test]
    public void Frames_MovingAndStationary_AreLiveThenStaleOrStationary()
    {
        _board.Add(_source, Pose("table", 0), isStationary: true);
        _board.Add(_source, Pose("box", 5), isStationary: false);

        Assert.That(_board.Frames(At(5.1)), Is.EqualTo(new[]
        {
            new FrameView("box", "world", "gateway", "live", 0.1), new FrameView("table", "world", "gateway", "stationary", null),
        }));

        _time.Advance(TimeSpan.FromSeconds(1.5));

        Assert.That(_board.Frames(At(6.6)).Select(frame => (frame.Name, frame.State)), Is.EqualTo(new[] { ("box", "stale"), ("table", "stationary") }));
    }

    [Test]
    public void Frames_ParentChanges_ReturnTheNewParent()
    {
        _board.Add(_source, Pose("box", 5), isStationary: false);
        _board.Add(_source, Pose("box", 6, "tool"), isStationary: false);

        Assert.That(_board.Frames(At(6)).Single().Parent, Is.EqualTo("tool"));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Frames_ParentIsUnknown_AreOrphansUntilItAppears(bool isStationary)
    {
        _board.Add(_source, Pose("box", 5, "nowhere"), isStationary);
        _board.Add(_source, Pose("lid", 5, "box"), isStationary: false);
        var start = _time.GetUtcNow();
        _board.Frames(At(5));
        _time.Advance(TimeSpan.FromSeconds(0.5));

        var orphans = _board.Frames(At(5));

        Assert.That(orphans.Select(frame => (frame.Name, frame.State, frame.Since)), Is.EqualTo(new (string, string, DateTimeOffset?)[]
        {
            ("box", "orphan", start), ("lid", "orphan", start),
        }));
        Assert.That(orphans.Select(frame => frame.Reason), Is.EqualTo(new[]
        {
            CellReasons.ParentMissing("nowhere"), CellReasons.ParentMissingAbove("box", "nowhere"),
        }));

        _board.Add(_source, Pose("nowhere", 5), isStationary: true);

        var states = _board.Frames(At(5)).Select(frame => (frame.Name, frame.State, frame.Reason, frame.SinceUtc));
        Assert.That(states, Is.EqualTo(new (string, string, string, string)[]
        {
            ("box", isStationary ? "stationary" : "live", null, null), ("lid", "live", null, null), ("nowhere", "stationary", null, null),
        }));
    }

    [TestCase("world", "live")]
    [TestCase("tool0", "live")]
    [TestCase("tool1", "orphan")]
    public void Frames_ParentIsTheWorldOrALink_AreLive(string parent, string state)
    {
        _board.Add(_source, Pose("box", 5, parent), isStationary: false);

        Assert.That(_board.Frames(At(5)).Single().State, Is.EqualTo(state));
    }

    [Test]
    public void Frames_ParentsOfEndedFramesFormACycle_AreOrphans()
    {
        _board.Add(_source, Pose("box", 5, "lid"), isStationary: false);
        _board.Add(_source, Pose("lid", 5, "box"), isStationary: false);

        Assert.That(_board.Frames(At(5)).Select(frame => frame.State), Is.EqualTo(new[] { "orphan", "orphan" }));
    }

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
    public void Frames_MoreThanAllowed_ReplaceOnlySilentFrames()
    {
        for (var i = 0; i < ProtocolLimits.Frames; i++) _board.Add(_source, Pose($"box{i}", 5), isStationary: false);
        _board.Add(_source, Pose("one more", 5), isStationary: false);
        Assert.That(_board.Frames(At(5)).Select(frame => frame.Name), Has.None.EqualTo("one more"));

        _time.Advance(TimeSpan.FromSeconds(2));
        _board.Add(_source, Pose("one more", 7), isStationary: false);

        Assert.That(_board.Frames(At(7)).Select(frame => frame.Name), Has.Member("one more").And.Exactly(ProtocolLimits.Frames).Items);
    }

    [Test]
    public void Signals_RepeatedThenEnded_KeepTheTimeOfTheChange()
    {
        _board.Add(_source, new SignalsMessage(At(5), new SignalValue("grip", 1)));
        _board.Add(_source, new SignalsMessage(At(7), new SignalValue("grip", 1)));
        Assert.That(_board.Signals(At(8)), Is.EqualTo(new[] { new SignalView("grip", 1, "gateway", "live", 3) }));

        _board.End(_source, ["grip", "unknown"]);
        var ended = _board.Signals(At(8)).Single();
        Assert.That((ended.State, ended.Reason, ended.Since), Is.EqualTo(("ended", EventTexts.SourceEnded("gateway"), _time.GetUtcNow())));

        _board.Add(_source, new SignalsMessage(At(9), new SignalValue("grip", 0)));
        Assert.That(_board.Signals(At(9.5)), Is.EqualTo(new[] { new SignalView("grip", 0, "gateway", "live", 0.5) }));
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

        _time.Advance(TimeSpan.FromSeconds(1.5));

        Assert.That(_board.Frames(At(9)).Select(frame => (frame.Name, frame.State)), Is.EqualTo(new[] { ("box", "stale") }), "the source has stopped reporting");
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
    public void Reports_FromManyAdaptersWithManyNames_AreBounded()
    {
        for (var adapter = 0; adapter < 100; adapter++)
            _reports.Add($"a{adapter}", [.. Enumerable.Range(0, 1000).Select(i => KeyValuePair.Create($"frame/{adapter}-{i}", "fault 1700000000.000 gone"))]);
        _reports.Add("damaged", [KeyValuePair.Create("frame/x", "gone"), KeyValuePair.Create("frame/y", "stale 1 x")]);

        var troubled = _reports.Troubled("frame/");

        Assert.That(troubled, Has.Count.EqualTo(CellReports.MaxAdapters * ProtocolLimits.Frames));
        Assert.That(troubled.Select(one => one.Adapter), Has.None.EqualTo("damaged"));
    }
}
