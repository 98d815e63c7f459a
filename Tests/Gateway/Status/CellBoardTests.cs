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
        _board = new CellBoard(_time, _reports, link => link is "tool0" or "base" ? "base" : null);
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

    [TestCase("world", "live")]
    [TestCase("nowhere", "orphan")]
    public void Frames_ParentIsALinkOfARobotWithAMovingBase_DependOnTheBase(string parentOfBase, string state)
    {
        _board.Add(_source, Pose("box", 5, "tool0"), isStationary: false);
        _board.Add(_source, Pose("base", 5, parentOfBase), isStationary: false);

        Assert.That(_board.Frames(At(5)).Select(frame => frame.State), Is.EqualTo(new[] { state, state }));
    }

    void Refuse(string topic, string name) => _board.Refuse(_source, topic, new LeftOut(DropReason.NotFinite, name, "is wrong"));

    [Test]
    public void Frames_OnlyRefused_AreListedUntilTheMessagesStop()
    {
        Refuse(RosTopics.Tf, "box");
        var start = _time.GetUtcNow();
        _time.Advance(TimeSpan.FromSeconds(1));
        Refuse(RosTopics.Tf, "box");

        Assert.That(_board.Frames(At(5)), Is.EqualTo(new[]
        {
            new FrameView("box", null, "gateway", "refused", null, "the gateway drops the samples of gateway: is wrong (NotFinite)") { Since = start },
        }));

        _time.Advance(CellBoard.RefusedFor);

        Assert.That(_board.Frames(At(15)), Is.Empty);
    }

    [Test]
    public void Frames_RefusedAfterValidPoses_AreRefusedOnlyWithoutValidPoses()
    {
        _board.Add(_source, Pose("box", 5), isStationary: false);
        _board.Add(_source, Pose("table", 5), isStationary: true);
        Refuse(RosTopics.Tf, "box");
        Refuse(RosTopics.TfStatic, "table");
        Assert.That(States(), Is.EqualTo(new[] { ("box", "live"), ("table", "refused") }), "a stationary frame is sent only once");

        _time.Advance(TimeSpan.FromSeconds(1.5));
        Refuse(RosTopics.Tf, "box");
        Assert.That(States(), Is.EqualTo(new[] { ("box", "refused"), ("table", "refused") }));

        _time.Advance(CellBoard.RefusedFor);
        _board.Add(_source, Pose("table", 5), isStationary: true);
        Assert.That(States(), Is.EqualTo(new[] { ("box", "stale"), ("table", "stationary") }));

        IEnumerable<(string, string)> States() => _board.Frames(At(9)).Select(frame => (frame.Name, frame.State));
    }

    [Test]
    public void Signals_Refused_AreListedUntilTheNextValidValue()
    {
        _board.Add(_source, new SignalsMessage(At(5), new SignalValue("grip", 1)));
        Refuse(RosTopics.Signals, "grip");
        Refuse(RosTopics.Signals, "lamp");
        _time.Advance(TimeSpan.FromMinutes(5));

        Assert.That(_board.Signals(At(9)).Select(signal => (signal.Name, signal.State, signal.Value)), Is.EqualTo(new (string, string, double?)[]
        {
            ("grip", "refused", 1), ("lamp", "refused", null),
        }));
        Assert.That(_board.FaultySignals().Select(one => one.Name), Is.EqualTo(new[] { "grip", "lamp" }));

        _board.Add(_source, new SignalsMessage(At(9), new SignalValue("grip", 1), new SignalValue("lamp", 1)));

        Assert.That(_board.Signals(At(9)).Select(signal => signal.State), Is.EqualTo(new[] { "live", "live" }));
        Assert.That(_board.FaultySignals(), Is.Empty);
    }

    [Test]
    public void FramesAndSignals_ManyRefusedNames_AreBoundedAndListedBesideTheMaximumOfPublishedOnes()
    {
        for (var i = 0; i < 1000; i++)
        {
            Refuse(RosTopics.Tf, $"a{i}");
            Refuse(RosTopics.Signals, $"a{i}");
        }

        Assert.That(_board.Frames(At(5)).Count, Is.EqualTo(CellBoard.MaxRefused));
        Assert.That(_board.Signals(At(5)).Count, Is.EqualTo(CellBoard.MaxRefused));

        for (var i = 0; i < ProtocolLimits.Frames; i++)
        {
            _board.Add(_source, Pose($"f{i}", 5), isStationary: false);
            _board.Add(_source, new SignalsMessage(At(5), new SignalValue($"s{i}", 1)));
        }

        Assert.That(_board.Frames(At(5)).Count(frame => frame.State == "live"), Is.EqualTo(ProtocolLimits.Frames));
        Assert.That(_board.Signals(At(5)).Count(signal => signal.State == "live"), Is.EqualTo(ProtocolLimits.Signals));
        Assert.That(_board.Frames(At(5)).Count(frame => frame.State == "refused"), Is.EqualTo(CellBoard.MaxRefused));
        Assert.That(_board.Signals(At(5)).Count(signal => signal.State == "refused"), Is.EqualTo(CellBoard.MaxRefused));
    }

    [Test]
    public void FramesAndSignals_OneMoreThanTheMaximum_IsListedAsRefused()
    {
        for (var i = 0; i < ProtocolLimits.Frames; i++)
        {
            _board.Add(_source, Pose($"f{i}", 5), isStationary: false);
            _board.Add(_source, new SignalsMessage(At(5), new SignalValue($"s{i}", 1)));
        }

        Refuse(RosTopics.Tf, "more");
        Refuse(RosTopics.Signals, "more");

        Assert.That(_board.Frames(At(5)).Single(frame => frame.State != "live").Name, Is.EqualTo("more"));
        Assert.That(_board.Signals(At(5)).Single(signal => signal.State != "live").Name, Is.EqualTo("more"));
    }

    [Test]
    public void Frames_StampDoesNotAdvance_AreStale()
    {
        for (var i = 0; i < 10; i++)
        {
            _board.Add(_source, Pose("box", 5), isStationary: false);
            _time.Advance(TimeSpan.FromSeconds(0.2));
        }

        var frame = _board.Frames(At(7)).Single();
        Assert.That((frame.State, frame.Reason), Is.EqualTo(("stale", CellReasons.StampsStopped)));

        _board.Add(_source, Pose("box", 4), isStationary: false);

        Assert.That(_board.Frames(At(7)).Single().State, Is.EqualTo("live"), "also if the clock of the source went back");
    }

    [Test]
    public void FramesAndSignals_InvalidMessagesOfAnotherSource_DoNotRefuseThem()
    {
        _board.Add(_source, Pose("table", 5), isStationary: true);
        _board.Add(_source, new SignalsMessage(At(5), new SignalValue("grip", 1)));
        var other = new MessageHub().OpenSource();

        _board.Refuse(other, RosTopics.TfStatic, new LeftOut(DropReason.NotFinite, "table", "is wrong"));
        _board.Refuse(other, RosTopics.Signals, new LeftOut(DropReason.NotFinite, "grip", "is wrong"));

        Assert.That((_board.Frames(At(5)).Single().State, _board.Signals(At(5)).Single().State), Is.EqualTo(("stationary", "live")));
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
