using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Status;
using Nowpose.Gateway.Status.Cell;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class CellBoardRefusalTests : CellBoardFixture
{
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
            new FrameView("box", null, "gateway", "refused", null, RequestMessages.Dropped("gateway", "is wrong", DropReason.NotFinite))
            {
                Since = start,
            },
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
        Assert.That(_board.FaultySignals(At(9)).Select(one => one.Name), Is.EqualTo(new[] { "grip", "lamp" }));

        _board.Add(_source, new SignalsMessage(At(9), new SignalValue("grip", 1), new SignalValue("lamp", 1)));

        Assert.That(_board.Signals(At(9)).Select(signal => signal.State), Is.EqualTo(new[] { "live", "live" }));
        Assert.That(_board.FaultySignals(At(9)), Is.Empty);
    }

    [Test]
    public void Signals_ControlClockSetBack_AreRefusedUntilTheyAreSentAgainOrTheirTimeHasCome()
    {
        var start = _time.GetUtcNow();
        _board.Add(_source, new SignalsMessage(At(7205), new SignalValue("grip", 1), new SignalValue("lamp", 1)));
        Assert.That(_board.Signals(At(7203.9)).Select(signal => signal.State), Is.EqualTo(new[] { "live", "live" }), "stamps up to 1 s ahead are accepted");

        Assert.That(_board.Signals(At(5)).Select(signal => (signal.State, signal.Reason, signal.Since)), Is.All.EqualTo(
            ("refused", CellReasons.StampAhead(7200), (DateTimeOffset?)start)));
        Assert.That(_board.FaultySignals(At(5)).Select(one => one.Name), Is.EqualTo(new[] { "grip", "lamp" }));

        _time.Advance(TimeSpan.FromSeconds(1));
        _board.Add(_source, new SignalsMessage(At(6), new SignalValue("grip", 1)));

        Assert.That(_board.FaultySignals(At(6)).Select(one => (one.Name, one.Report.Since)), Is.EqualTo(new[] { ("lamp", start) }));
        Assert.That(_board.Signals(At(7205)).Select(signal => signal.State), Is.EqualTo(new[] { "live", "live" }));
        Assert.That(_board.FaultySignals(At(7205)), Is.Empty);
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
    public void FramesAndSignals_InvalidMessagesOfAnotherSource_DoNotRefuseThem()
    {
        _board.Add(_source, Pose("table", 5), isStationary: true);
        _board.Add(_source, new SignalsMessage(At(5), new SignalValue("grip", 1)));
        var other = new MessageHub().OpenSource();

        _board.Refuse(other, RosTopics.TfStatic, new LeftOut(DropReason.NotFinite, "table", "is wrong"));
        _board.Refuse(other, RosTopics.Signals, new LeftOut(DropReason.NotFinite, "grip", "is wrong"));

        Assert.That((_board.Frames(At(5)).Single().State, _board.Signals(At(5)).Single().State), Is.EqualTo(("stationary", "live")));
    }

    // A stationary frame keeps its place without a source. The invalid pose of its next source may have been a new place.
    [Test]
    public void Frames_InvalidPoseOfAStationaryFrameWithoutSource_IsRefused([Values] bool isUnadvertised)
    {
        _board.Add(_source, Pose("table", 5), isStationary: true);
        if (isUnadvertised) _board.Leave(_source, RosTopics.TfStatic);
        else _source.Dispose();
        var next = new MessageHub().OpenSource();

        _board.Refuse(next, RosTopics.TfStatic, new LeftOut(DropReason.NotFinite, "table", "is wrong"));

        Assert.That(_board.Frames(At(5)).Single().State, Is.EqualTo("refused"));
        _board.Add(next, Pose("table", 6), isStationary: true);
        Assert.That(_board.Frames(At(6)).Single().State, Is.EqualTo("stationary"));
    }

    [Test]
    public void Signals_InvalidValueAfterTheSourceEnded_KeepsTheReasonOfTheEnd()
    {
        _board.Add(_source, new SignalsMessage(At(5), new SignalValue("grip", 1)));
        _source.Dispose();
        _board.End(_source, ["grip"]);

        _board.Refuse(new MessageHub().OpenSource(), RosTopics.Signals, new LeftOut(DropReason.NotFinite, "grip", "is wrong"));

        Assert.That(_board.Signals(At(5)).Single().State, Is.EqualTo("ended"));
    }

    [Test]
    public void Frames_MoreThanAllowed_ReplaceOnlyFramesWithoutASource()
    {
        for (var i = 0; i < ProtocolLimits.Frames; i++) _board.Add(_source, Pose($"box{i}", 5), isStationary: false);
        _board.Add(_source, Pose("one more", 5), isStationary: false);
        Assert.That(_board.Frames(At(5)).Select(frame => frame.Name), Has.None.EqualTo("one more"));

        _time.Advance(TimeSpan.FromSeconds(2));
        _board.EndFrame("box3");
        _board.Add(_source, Pose("one more", 7), isStationary: false);

        Assert.That(_board.Frames(At(7)).Select(frame => frame.Name), Has.None.EqualTo("box3"));
        Assert.That(_board.Frames(At(7)).Select(frame => frame.Name), Has.Member("one more").And.Exactly(ProtocolLimits.Frames).Items);
    }
}
