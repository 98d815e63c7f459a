using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Status;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class CellBoardTests : CellBoardFixture
{
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

    [TestCase(9.9, "live")]
    [TestCase(10.1, "stale")]
    [TestCase(600, "stale")]
    public void Frames_StampsAreOld_AreStaleFromTenSeconds(double age, string state)
    {
        for (var t = 1000.0; t < 1002; t += 0.1)
        {
            _board.Add(_source, Pose("box", t - age), isStationary: false, At(t));
            _board.Add(_source, Pose("table", t - age), isStationary: true, At(t));
            _board.Add(_source, Pose("lid", t, "box"), isStationary: false, At(t));
            _time.Advance(TimeSpan.FromSeconds(0.1));
        }

        var frames = _board.Frames(At(1002));

        var isLive = state == "live";
        Assert.That(frames.Select(frame => (frame.Name, frame.State, frame.Reason)), Is.EqualTo(new[]
        {
            ("box", state, isLive ? null : CellReasons.StampsOld), ("lid", isLive ? "live" : "parent-stale", isLive ? null : CellReasons.ParentNotCurrent("box")),
            ("table", "stationary", (string)null),
        }));
        Assert.That(frames[0].Since, Is.EqualTo(isLive ? null : _time.GetUtcNow()));

        _board.Add(_source, Pose("box", 1002), isStationary: false, At(1002));

        Assert.That(_board.Frames(At(1002))[0].State, Is.EqualTo("live"), "the clock of the source is correct again");
    }

    [Test]
    public void Frames_ParentsOfEndedFramesFormACycle_AreOrphans()
    {
        _board.Add(_source, Pose("box", 5, "lid"), isStationary: false);
        _board.Add(_source, Pose("lid", 5, "box"), isStationary: false);

        Assert.That(_board.Frames(At(5)).Select(frame => frame.State), Is.EqualTo(new[] { "orphan", "orphan" }));
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
}
