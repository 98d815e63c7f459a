using Nowpose.Cli.Headset;
using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Headset;

public class CellPartsTests
{
    sealed class SetClock : IHeadsetClock
    {
        public HeadsetTime Now => default;
    }

    [Test]
    public void Update_SourcesEnd_NamesTheirObjectsAndSignals()
    {
        const double start = 100, end = 105, now = 110;
        using var session = new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40)), RobotFiles.Load("youbot"), new SetClock());
        var parts = new CellParts(session);
        session.Signals.Add(new SignalsMessage(Control(start), new SignalValue("closed", 1), new SignalValue("running", 1)), Headset(start));
        session.Frames.Add(new TransformsMessage(Pose("fixture", 0)), true, Headset(start));

        for (var frame = 0; start + frame / 60.0 <= now; frame++)
        {
            var t = start + frame / 60.0;
            session.Clock.Add(new SyncExchange(Headset(t - 0.001), Control(t), Control(t), Headset(t + 0.001)), out _);
            if (frame % 3 == 0) session.Frames.Add(new TransformsMessage(t < end ? [Pose("box", t), Pose("lid", t)] : [Pose("lid", t)]), false, Headset(t));
            if (t >= end) session.Listener.SignalStatusReceived(
                new JointStatusMessage([new JointReport("closed", JointDataState.Stale, Control(end), "its source has ended")]), Headset(t));
            session.Tick(Headset(t));
            parts.Update();
        }

        var (objects, signals) = parts.NotCurrent(Headset(now));
        var box = objects.Single();
        Assert.That((box.Name, box.Reason), Is.EqualTo(("box", FrameMessages.PosesStopped)));
        Assert.That(box.SinceS, Is.EqualTo(now - end).Within(0.1));
        var closed = signals.Single();
        Assert.That((closed.Name, closed.Reason), Is.EqualTo(("closed", "its source has ended")));
        Assert.That(closed.SinceS, Is.EqualTo(now - end).Within(0.1));
    }

    // The session shows only the robot arm1.
    [Test]
    public void Update_ObjectsOnAnotherRobot_AreNotFollowedUntilTheirParentIsInTheCell()
    {
        const double start = 100;
        using var session = new CompensationSession(
            new SessionSettings(
                new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40), robotNamespace: "arm1"),
            RobotFiles.Load("youbot"), new SetClock());
        var parts = new CellParts(session);
        var frame = 0;
        string Run(int frames, string parentOfBox)
        {
            for (var end = frame + frames; frame < end; frame++)
            {
                var t = start + frame / 60.0;
                session.Clock.Add(new SyncExchange(Headset(t - 0.001), Control(t), Control(t), Headset(t + 0.001)), out _);
                if (frame % 3 == 0) session.Frames.Add(new TransformsMessage(Pose("screw", t, "box"), Pose("box", t, parentOfBox)), false, Headset(t));
                session.Tick(Headset(t));
                parts.Update();
            }
            return string.Join(", ", parts.NotCurrent(Headset(start + frame / 60.0)).Objects.Select(part => part.Name).Order());
        }
        session.Frames.Add(
            new TransformsMessage(Pose("lid", 0, "hall"), Pose("cap", 0, "arm1/unknown"), Pose("tray", 0, "arm2/tool0")), true, Headset(start));

        Assert.That(Run(120, "arm2/tool0"), Is.EqualTo("cap, lid"), "their parents are unknown");
        Assert.That(
            parts.NotFollowed().Select(part => (part.Name, part.Link)).Order(),
            Is.EqualTo(new[] { ("box", "arm2/tool0"), ("screw", "arm2/tool0"), ("tray", "arm2/tool0") }));

        Assert.That(Run(120, FrameParents.World), Is.EqualTo("cap, lid"));
        Assert.That(parts.NotFollowed().Select(part => part.Name), Is.EqualTo(new[] { "tray" }));
        Assert.That(session.Frames.StateOf(session.Frames.Find("screw")), Is.EqualTo(PoseState.Current));

        Assert.That(Run(120, "arm2/tool0"), Is.EqualTo("cap, lid"), "the robot has gripped the box again");
    }

    // The other robot handles parts whose names are always new.
    [Test]
    public void NotFollowed_SilentObjectsOnAnotherRobot_AreForgottenWhenOthersArrive()
    {
        using var session = new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40), robotNamespace: "arm1"),
            RobotFiles.Load("youbot"), new SetClock());
        var parts = new CellParts(session);
        for (var k = 0; k < 40; k++)
        {
            session.Clock.Add(new SyncExchange(Headset(k - 0.001), Control(k), Control(k), Headset(k + 0.001)), out _);
            session.Frames.Add(new TransformsMessage(Pose($"part_{k}", k, "arm2/tool0")), false, Headset(k));
            session.Tick(Headset(k));
            parts.Update();
        }

        Assert.That(parts.NotFollowed().Select(part => part.Name), Is.EquivalentTo(Enumerable.Range(29, 11).Select(k => $"part_{k}")));
    }

    static FrameTransform Pose(string child, double stamp, string parent = FrameParents.World) =>
        new(Control(stamp), parent, child, 0.1 * stamp, 0, 0, 0, 0, 0, 1);

    static ControlTime Control(double seconds) => ControlTime.FromSeconds(seconds);

    static HeadsetTime Headset(double seconds) => HeadsetTime.FromSeconds(seconds);
}
