using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Recording;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Simulation.Work;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Session;

[NonParallelizable] // measures allocations
public class TickAllocationTests
{
    [TestCase("hold", false)]
    [TestCase("quadratic", false)]
    [TestCase("quadratic", true)]
    [TestCase("quadratic-h4", false)]
    [TestCase("cubic", false)]
    [TestCase("adaptive", true)]
    public void TickAndFill_NewSamplesAfterWarmUp_AllocateNothing(string predictor, bool isRecorded)
    {
        var robot = RobotFiles.Load("youbot");
        var names = robot.MovingJoints.Select(joint => joint.Name).ToArray();
        using var session = new CompensationSession(
            new SessionSettings(
                new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.FromMilliseconds(40)), new PredictionSettings(predictor)),
            robot, new StopwatchHeadsetClock());
        using var recorder = isRecorded ? new SessionRecorder(session, new RecordingSettings("nowhere", () => Stream.Null)) : null;
        var statistics = new SessionStatistics();
        var allocated = 0L;
        for (var frame = 0; frame < 2000; frame++)
        {
            var now = HeadsetTime.FromSeconds(10 + frame / 60.0);
            var control = new ControlTime(now.SinceEpoch);
            if (frame % 12 == 0)
                session.Clock.Add(new SyncExchange(now - TimeSpan.FromMilliseconds(2), control, control, now), out _);
            if (frame % 3 == 0)
                session.Listener.Received(new JointStateMessage(control - TimeSpan.FromMilliseconds(80), names, Positions(names.Length, frame)), now);

            var before = GC.GetAllocatedBytesForCurrentThread();
            session.Rendered(TimeSpan.FromMilliseconds(10 + frame % 7), RenderTimeSourceKind.DisplayGpuTime);
            session.Tick(now);
            session.Fill(statistics, now);
            if (frame >= 500) allocated += GC.GetAllocatedBytesForCurrentThread() - before;
        }

        Assert.That(allocated, Is.EqualTo(0));
        Assert.That(statistics.Samples, Is.GreaterThan(600));
        Assert.That(statistics.RenderTime, Is.Not.Null);
    }

    [TestCase("quadratic", false)]
    [TestCase("adaptive", true)]
    public void TickAndFill_FollowingAPlan_AllocateNothing(string predictor, bool isRecorded)
    {
        var robot = RobotFiles.Load("youbot");
        var start = HeadsetTime.FromSeconds(10);
        var conditions = new VirtualCellSettings(50, 55, 105, 0, 0, NetworkProfile.Wifi);
        var clock = new VirtualClock(start, TimeSpan.FromSeconds(1000), 37e-6);
        var cell = new VirtualCell(new PickAndPlaceMotion(robot), clock, conditions, seed: 3, start) { PlanLag = TimeSpan.FromMilliseconds(40) };
        using var session = new CompensationSession(
            new SessionSettings(
                new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.FromMilliseconds(40)), new PredictionSettings(predictor)),
            robot, new StopwatchHeadsetClock());
        using var recorder = isRecorded ? new SessionRecorder(session, new RecordingSettings("nowhere", () => Stream.Null)) : null;
        var statistics = new SessionStatistics();
        var (plans, planned, allocated) = (0, 0, 0L);
        session.Intake.PlanJudged += (_, _) => plans++;
        for (var frame = 0; frame < 2000; frame++)
        {
            var now = start + TimeSpan.FromTicks(frame * TimeSpan.TicksPerSecond / 60);
            cell.Run(now, session);

            var before = GC.GetAllocatedBytesForCurrentThread();
            var shown = session.Tick(now);
            session.Fill(statistics, now);
            if (frame < 500) continue;
            allocated += GC.GetAllocatedBytesForCurrentThread() - before;
            if (shown.Kinds[0] == PredictionKind.Planned) planned++;
        }

        Assert.That(allocated, Is.EqualTo(0), "seed 3");
        Assert.That(plans, Is.GreaterThan(100), "each plan is applied within a frame");
        Assert.That(planned, Is.GreaterThan(1000), "most of the 1500 frames are planned");
    }

    [Test]
    public void Tick_RecordedObjects_AllocatesNothing()
    {
        using var session = new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.FromMilliseconds(40))),
            RobotFiles.Load("youbot"), new StopwatchHeadsetClock());
        using var recorder = new SessionRecorder(session, new RecordingSettings("nowhere", () => Stream.Null));
        string[] names = [.. Enumerable.Range(0, 10).Select(i => "part_" + i)];
        foreach (var name in names) session.Frames.Need(name);
        var (allocated, current) = (0L, 0);
        for (var frame = 0; frame < 1200; frame++)
        {
            var now = HeadsetTime.FromSeconds(10 + frame / 60.0);
            var control = new ControlTime(now.SinceEpoch);
            if (frame % 12 == 0)
                session.Clock.Add(new SyncExchange(now - TimeSpan.FromMilliseconds(2), control, control, now), out _);
            if (frame % 3 == 0)
                session.Frames.Add(new TransformsMessage([.. names.Select(name => new FrameTransform(
                    control - TimeSpan.FromMilliseconds(80), "world", name, Math.Sin(frame * 0.05), 0, 0, 0, 0, 0, 1))]), false, now);

            var before = GC.GetAllocatedBytesForCurrentThread();
            session.Tick(now);
            if (frame < 500) continue;
            allocated += GC.GetAllocatedBytesForCurrentThread() - before;
            if (session.Frames.StateOf(session.Frames.Find(names[0])) == PoseState.Current) current++;
        }

        Assert.That(allocated, Is.EqualTo(0));
        Assert.That(current, Is.GreaterThan(600));
    }

    // No message arrives for several samples, and then all of them arrive before one frame. No frame is shown in between, or the frames continue.
    [TestCase(20, true)]
    [TestCase(20, false)]
    [TestCase(50, true)]
    [TestCase(50, false)]
    public void Tick_DelayedMessagesArriveTogether_AllocatesNothing(double samplingMs, bool areFramesDelayed)
    {
        var robot = RobotFiles.Load("youbot");
        var start = HeadsetTime.FromSeconds(10);
        var work = new CellWork(robot, new PickAndPlaceMotion(robot));
        var conditions = new VirtualCellSettings(samplingMs, 55, 105, 0, 0, NetworkProfile.Wifi);
        var cell = new VirtualCell(new CellMotion(work), new VirtualClock(start, TimeSpan.FromSeconds(1000), 37e-6), conditions, seed: 3, start);
        using var session = new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40)), robot, new StopwatchHeadsetClock());
        using var recorder = new SessionRecorder(session, new RecordingSettings("nowhere", () => Stream.Null));
        foreach (var name in work.Names) session.Frames.Need(name);
        foreach (var name in work.Signals) session.Signals.Need(name);
        var random = new Random(4);
        var (now, allocated, held) = (start, 0L, 0);
        Run(10, hasMessages: true);
        allocated = 0;

        for (var i = 0; i < 20; i++)
        {
            var delay = 0.3 + 1.7 * random.NextDouble();
            if (areFramesDelayed) now += TimeSpan.FromSeconds(delay);
            else Run(delay, hasMessages: false);
            Run(2, hasMessages: true);
        }

        Assert.That(allocated, Is.Zero, "seeds 3 and 4");
        Assert.That(held, areFramesDelayed ? Is.Zero : Is.GreaterThan(100));
        Assert.That(session.Tick(now).State, Is.EqualTo(PoseState.Current));

        void Run(double seconds, bool hasMessages)
        {
            for (var frame = 0; frame < seconds * 60; frame++)
            {
                now += TimeSpan.FromTicks(TimeSpan.TicksPerSecond / 60);
                if (hasMessages) cell.Run(now, session);
                var before = GC.GetAllocatedBytesForCurrentThread();
                var state = session.Tick(now).State;
                allocated += GC.GetAllocatedBytesForCurrentThread() - before;
                if (state == PoseState.Held) held++;
            }
        }
    }

    static double[] Positions(int count, int frame) => [.. Enumerable.Range(0, count).Select(joint => 0.005 * Math.Sin(frame * 0.05 + joint))];
}
