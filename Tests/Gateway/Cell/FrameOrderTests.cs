using Nowpose.Gateway.Hub;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Cell.CellTexts;

namespace Nowpose.Headless.Tests.Gateway.Cell;

/// <summary>Tests messages that change the order of frames in the tree.</summary>
[FixtureLifeCycle(LifeCycle.InstancePerTestCase)]
public class FrameOrderTests
{
    readonly MessageHub _hub = new();
    readonly List<LeftOut> _leftOut = [];

    // Returns the frames of the published message, each with its parent.
    string[] Send(HubSource source, params FrameTransform[] frames)
    {
        var published = new List<string>();
        using var subscription = _hub.SubscribeToNew(RosTopics.TfStatic, message =>
        {
            var transforms = (TransformsMessage)message.Content;
            for (var i = 0; i < transforms.Count; i++) published.Add($"{transforms[i].Parent}-{transforms[i].Child}");
        });
        source.Publish(new TransformsMessage(frames), isStationary: true, _leftOut);
        return [.. published];
    }

    // Headsets judge the transforms one by one, so the order of a message must be possible.
    [Test]
    public void Publish_FramesExchangePlaces_PublishesAllInAPossibleOrder()
    {
        using var source = _hub.OpenSource();
        Send(source, Frame("a"), Frame("b", "a"), Frame("c", "b"));

        var published = Send(source, Frame("a", "b"), Frame("b", "c"), Frame("c"));

        Assert.That(published, Is.EqualTo(new[] { "world-c", "c-b", "b-a" }));
        Assert.That(_leftOut, Is.Empty);
    }

    [Test]
    public void Publish_LongChainIsReversed_PublishesAll()
    {
        using var source = _hub.OpenSource();
        string Name(int i) => i == 0 ? "world" : "f" + i;
        FrameTransform[] chain = [.. Enumerable.Range(1, ProtocolLimits.FrameDepth).Select(i => Frame(Name(i), Name(i - 1)))];
        Send(source, chain);

        var published = Send(source, [.. chain.Select((_, i) => Frame(Name(i + 1), Name((i + 2) % (chain.Length + 1))))]);

        Assert.That(published, Has.Length.EqualTo(ProtocolLimits.FrameDepth));
        Assert.That(_leftOut, Is.Empty);
    }

    [Test]
    public void Publish_CycleWithinAMessage_LeavesOutItsLastFrameOnce()
    {
        using var source = _hub.OpenSource();

        var published = Send(source, Frame("a", "b"), Frame("b", "a"), Frame("c", "b"));

        Assert.That(published, Is.EqualTo(new[] { "b-a", "b-c" }));
        Assert.That(_leftOut.Select(one => (one.Name, one.Reason)), Is.EqualTo(new[] { ("b", DropReason.FrameCycle) }));
    }
}
