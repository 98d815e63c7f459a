using System.Diagnostics;
using Nowpose.Gateway.Hub;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Cell.CellTexts;

namespace Nowpose.Headless.Tests.Gateway.Cell;

/// <summary>Tests which frame a new one replaces in a cell with the maximum number of frames.</summary>
[FixtureLifeCycle(LifeCycle.InstancePerTestCase)]
public class FullCellTests
{
    readonly MessageHub _hub = new();
    readonly List<string> _replaced = [];
    readonly List<LeftOut> _leftOut = [];

    public FullCellTests() => _hub.Frames.Replaced += _replaced.Add;

    bool Send(HubSource source, double seconds, params FrameTransform[] frames) => source.Publish(
        new TransformsMessage(frames), isStationary: false, _leftOut, 1 + (long)(seconds * Stopwatch.Frequency));

    // Fills the cell with frames of which each is silent for longer than the next one.
    HubSource Fill(string parent = "world")
    {
        var source = _hub.OpenSource();
        for (var i = 0; i < ProtocolLimits.Frames; i++) Send(source, 0.001 * i, Frame("part" + i, i == 0 ? "world" : parent));
        return source;
    }

    [TestCase(10.0, false)]
    [TestCase(10.1, true)]
    public void Publish_NewNameForEachWorkpiece_ReplacesTheOneThatIsSilentForTheLongestTime(double silence, bool isReplaced)
    {
        using var source = Fill();
        Send(source, 0.5 * silence, Frame("part0"));

        Assert.That(Send(source, 0.001 + silence, Frame("new")), Is.EqualTo(isReplaced));

        string[] replaced = isReplaced ? ["part1"] : [];
        DropReason[] dropped = isReplaced ? [] : [DropReason.TooManyFrames];
        Assert.That(_replaced, Is.EqualTo(replaced));
        Assert.That(_leftOut.Select(one => one.Reason), Is.EqualTo(dropped));
    }

    [Test]
    public void Publish_SilentFrameHasChildren_ReplacesAnotherOne()
    {
        using var source = Fill(parent: "part0");

        Send(source, 20, Frame("new", "part1"));

        Assert.That(_replaced, Is.EqualTo(new[] { "part2" }));
    }

    [Test]
    public void Publish_StationaryFrameWithoutSourceHasChildren_ReplacesAnotherOne()
    {
        var ended = _hub.OpenSource();
        ended.Publish(new TransformsMessage(Frame("conveyor"), Frame("table")), isStationary: true, _leftOut);
        for (var i = 3; i < ProtocolLimits.Frames; i++) ended.Publish(new TransformsMessage(Frame("old" + i)), isStationary: true, _leftOut);
        ended.Dispose();
        using var source = _hub.OpenSource();
        Send(source, 1, Frame("workpiece", "conveyor"));

        Send(source, 1, Frame("next", "table"));

        Assert.That(_replaced, Is.EqualTo(new[] { "old3" }));
    }

    [Test]
    public async Task Publish_StationaryFrameWithoutSourceIsTheBaseOfARobot_ReplacesAnotherOne()
    {
        using var robot = _hub.OpenSource();
        robot.Describe("<robot name='r'><link name='base'/></robot>", "arm1");
        await _hub.Links.Read;
        var ended = _hub.OpenSource();
        ended.Publish(new TransformsMessage(Frame("arm1/base")), isStationary: true, _leftOut);
        for (var i = 1; i < ProtocolLimits.Frames; i++) ended.Publish(new TransformsMessage(Frame("old" + i)), isStationary: true, _leftOut);
        ended.Dispose();

        Send(robot, 1, Frame("next"));

        Assert.That(_replaced, Is.EqualTo(new[] { "old1" }));
    }

    [Test]
    public void Publish_ReplacedFrameIsPublishedAgain_IsAccepted()
    {
        using var source = Fill();
        using var other = _hub.OpenSource();
        Send(source, 20, Frame("new"));

        Assert.That(Send(other, 20, Frame("part0")), Is.True, "the frame has no source any more");

        Assert.That(_replaced, Is.EqualTo(new[] { "part0", "part1" }));
    }
}
