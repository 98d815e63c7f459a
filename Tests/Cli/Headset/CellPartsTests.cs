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

    static FrameTransform Pose(string child, double stamp) => new(Control(stamp), FrameParents.World, child, 0.1 * stamp, 0, 0, 0, 0, 0, 1);

    static ControlTime Control(double seconds) => ControlTime.FromSeconds(seconds);

    static HeadsetTime Headset(double seconds) => HeadsetTime.FromSeconds(seconds);
}
