using Nowpose.Frames;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Session;

/// <summary>Tests the allocations of a frame with many objects, signals and two robots. One robot picks and places an object every second.</summary>
[NonParallelizable] // measures allocations
public class CellAllocationTests
{
    const int Objects = 50;
    const double Interval = 0.05, Frame = 1 / 60.0;

    [Test]
    public void Tick_FiftyObjectsAndTwoRobots_AllocatesNothing()
    {
        var robot = RobotFiles.Load("youbot");
        var session = new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40)), robot, new StopwatchHeadsetClock());
        session.Robots.Add("arm2", robot);
        var names = Enumerable.Range(0, Objects).Select(i => $"object{i}").ToArray();
        foreach (var name in names) session.Frames.Need(name);
        var joints = robot.MovingJoints.Select(joint => joint.Name).ToArray();
        long allocated = 0;
        var next = 10.0;
        for (var i = 0; i < 1200; i++)
        {
            var now = 11 + i * Frame;
            for (; next + 0.08 <= now; next += Interval) Send(session, names, joints, next);
            Exchange(session, now);
            var before = GC.GetAllocatedBytesForCurrentThread();
            session.Tick(HeadsetTime.FromSeconds(now));
            if (i >= 600) allocated += GC.GetAllocatedBytesForCurrentThread() - before;
        }

        Assert.That(session.Frames.Find(names[0]).State, Is.EqualTo(FrameState.Current));
        Assert.That(session.Frames.Find(names[^1]).State, Is.EqualTo(FrameState.Current));
        Assert.That(session.Robots[1].Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(allocated, Is.Zero);
    }

    // The gripper waits for an object whose poses have stopped, grips nothing, and then looks for objects that appear.
    [Test]
    public void Tick_GripperClosedWithoutAnObject_AllocatesNothing()
    {
        const double closed = 21;
        var robot = RobotFiles.Load("youbot");
        var session = new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40)), robot, new StopwatchHeadsetClock());
        session.Robots.Add("arm2", robot);
        var names = Enumerable.Range(0, Objects).Select(i => $"object{i}").ToArray();
        foreach (var name in names) session.Frames.Need(name);
        var grip = new ReachGrip(session.Frames.Tree, session.Robots[0], robot.IndexOfLink(robot.ToolLink.Name), 1e-3, names);
        session.Grips.Add(grip, "grip");
        var joints = robot.MovingJoints.Select(joint => joint.Name).ToArray();
        long allocated = 0;
        var next = 10.0;
        for (var i = 0; i < 1200; i++)
        {
            var now = 11 + i * Frame;
            for (; next + 0.08 <= now; next += Interval)
            {
                Send(session, next < closed - 1 ? names : names[..^1], joints, next);
                session.Listener.SignalsReceived(
                    new SignalsMessage(ControlTime.FromSeconds(next), new SignalValue("grip", next < closed ? 0 : 1)), HeadsetTime.FromSeconds(next + 0.08));
            }
            Exchange(session, now);
            var before = GC.GetAllocatedBytesForCurrentThread();
            session.Tick(HeadsetTime.FromSeconds(now));
            // At the first closing, the gripper allocates memory for its objects.
            if (now > closed + 0.5) allocated += GC.GetAllocatedBytesForCurrentThread() - before;
        }

        Assert.That((grip.Held, grip.Fault, allocated), Is.EqualTo(((string)null, (string)null, 0L)));
    }

    static void Send(CompensationSession session, string[] names, string[] joints, double t)
    {
        var arrival = HeadsetTime.FromSeconds(t + 0.08);
        var stamp = ControlTime.FromSeconds(t);
        var poses = names.Select((name, i) => RigidTransform.FromXyzRpy(Math.Sin(t + i), Math.Cos(t), i, 0, 0, t).ToTransform(
            stamp, i == 0 && Math.Round(t / Interval) % 20 < 10 ? "arm2/arm_link_5" : FrameParents.World, name));
        session.Listener.FramesReceived(new TransformsMessage(poses.ToArray()), false, arrival);
        session.Listener.SignalsReceived(new SignalsMessage(stamp, new SignalValue("running", Math.Round(t) % 2)), arrival);
        foreach (var robot in new[] { "", "arm2" })
            session.Listener.Received(new JointStateMessage(stamp, joints, joints.Select((_, i) => 0.1 * Math.Sin(t + i)).ToArray()), arrival, robot);
    }

    static void Exchange(CompensationSession session, double at)
    {
        var control = ControlTime.FromSeconds(at);
        var half = TimeSpan.FromMilliseconds(1);
        session.Clock.Add(new SyncExchange(HeadsetTime.FromSeconds(at) - half, control, control, HeadsetTime.FromSeconds(at) + half), out _);
    }
}
