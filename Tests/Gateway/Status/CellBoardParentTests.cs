using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>Tests the state of a frame whose own poses are current, but whose parent is not.</summary>
public class CellBoardParentTests : CellBoardFixture
{
    (string State, string Reason) Of(string name, JointDataState? elbow = null)
    {
        JointSnapshot[] joints = elbow is { } state ? [new JointSnapshot("elbow", "plc", state, default, null, 0, "")] : [];
        var frame = _board.Frames(At(5), joints).Single(one => one.Name == name);
        return (frame.State, frame.Reason);
    }

    [TestCase(false, "live")]
    [TestCase(true, "stationary")]
    public void Frames_ParentIsStale_AreNotCurrentUntilItsNextPose(bool isStationary, string state)
    {
        _board.Add(_source, Pose("belt", 5), isStationary: false);
        _time.Advance(TimeSpan.FromSeconds(1.5));
        _board.Add(_source, Pose("box", 6, "belt"), isStationary);
        _board.Add(_source, Pose("lid", 6, "box"), isStationary);

        Assert.That((Of("belt").State, Of("box"), Of("lid")), Is.EqualTo((
            "stale", ("parent-stale", CellReasons.ParentNotCurrent("belt")), ("parent-stale", CellReasons.ParentNotCurrentAbove("belt")))));
        Assert.That(_board.Frames(At(6)).Single(frame => frame.Name == "lid").Since, Is.EqualTo(_time.GetUtcNow()));

        _board.Add(_source, Pose("belt", 6.5), isStationary: false);

        Assert.That((Of("box"), Of("lid")), Is.EqualTo(((state, (string)null), (state, (string)null))));
    }

    [Test]
    public void Frames_SourceOfTheParentHasEnded_AreOrphansUntilItIsPublishedAgain()
    {
        _board.Add(_source, Pose("belt", 5), isStationary: false);
        _board.Add(_source, Pose("box", 5, "belt"), isStationary: false);

        _board.EndFrame("belt");

        Assert.That(Of("box"), Is.EqualTo(("orphan", CellReasons.ParentMissing("belt"))));
        _board.Add(_source, Pose("belt", 6), isStationary: false);
        Assert.That(Of("box").State, Is.EqualTo("live"));
    }

    [TestCase(JointDataState.Live, "live")]
    [TestCase(JointDataState.Rest, "live")]
    [TestCase(JointDataState.Stale, "parent-stale")]
    [TestCase(JointDataState.Fault, "parent-stale")]
    [TestCase(null, "parent-stale")]
    public void Frames_ParentIsALink_AreCurrentOnlyWithTheJointsOfTheLink(JointDataState? elbow, string state)
    {
        _board.Add(_source, Pose("part", 5, "tool0"), isStationary: false);
        _board.Add(_source, Pose("foot", 5, "base"), isStationary: false);

        Assert.That((Of("part", elbow).State, Of("foot", elbow).State), Is.EqualTo((state, "live")));
    }

    [Test]
    public void Frames_SourceOfAMovingBaseHasEnded_AreNotCurrent()
    {
        _board.Add(_source, Pose("base", 5), isStationary: false);
        _board.Add(_source, Pose("part", 5, "tool0"), isStationary: false);

        _board.EndFrame("base");

        Assert.That(Of("part", JointDataState.Live), Is.EqualTo(("parent-stale", CellReasons.ParentNotCurrent("base"))));
    }

    [Test]
    public void Frames_FullCellWithoutSource_ListTheFramesThatTheGatewayPublishes()
    {
        var hub = new MessageHub();
        hub.Frames.Replaced += _board.RemoveFrame;
        hub.Frames.Ended += _board.EndFrame;
        using var subscription = hub.Subscribe(RosTopics.TfStatic, message => _board.Add(message.Source, (TransformsMessage)message.Content, true));
        var ended = hub.OpenSource();
        for (var i = 0; i < ProtocolLimits.Frames; i++) ended.Publish(Pose($"f{i:000}", 5), isStationary: true, []);
        ended.Dispose();

        using var next = hub.OpenSource();
        next.Publish(Pose("new", 6), isStationary: true, []);

        var published = hub.ReadLatched(RosTopics.TfStatic, () => 0)
            .SelectMany(message => Enumerable.Range(0, ((TransformsMessage)message.Content).Count)
                .Select(i => ((TransformsMessage)message.Content)[i].Child)).Order(StringComparer.Ordinal);
        Assert.That(_board.Frames(At(6)).Select(frame => frame.Name), Has.Member("new").And.EqualTo(published));
    }
}
