using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Session;

/// <summary>Tests the displayed joint positions that a headset reports.</summary>
[NonParallelizable] // measures allocations
public class DisplayedJointsTests
{
    static readonly TimeSpan Visualisation = TimeSpan.FromMilliseconds(40);

    readonly CompensationSession _session = new(
        new SessionSettings(new ConnectionSettings("127.0.0.1", headsetName: "left door"), new VisualisationLatency(Visualisation)),
        RobotFiles.Load("youbot"), new StopwatchHeadsetClock());

    [OneTimeTearDown]
    public void TearDown() => _session.Dispose();

    [Test, Order(1)]
    public void Displayed_ClockUnsynchronised_IsNull()
    {
        _session.Listener.Received(Sample(HeadsetTime.FromSeconds(9)), HeadsetTime.FromSeconds(9));

        _session.Tick(HeadsetTime.FromSeconds(9));

        Assert.That(_session.Displayed(), Is.Null);
    }

    [Test, Order(2)]
    public void Displayed_EachFrame_IsReturnedOnceWithTheDisplayTime()
    {
        var now = HeadsetTime.FromSeconds(10);
        for (var i = 0; i < 60; i++) Frame(now += TimeSpan.FromMilliseconds(50));
        var frame = _session.Tick(now);

        var displayed = _session.Displayed();

        Assert.That(displayed.Stamp, Is.EqualTo(frame.DisplayTime));
        Assert.That((displayed.Stamp - new ControlTime(now.SinceEpoch) - Visualisation).Duration(), Is.LessThan(TimeSpan.FromMilliseconds(1)));
        Assert.That(displayed.FrameId, Is.EqualTo("left door"));
        Assert.That(displayed.Names, Is.EqualTo(_session.Robot.MovingJoints.Select(joint => joint.Name)));
        Assert.That(displayed.Positions, Is.EqualTo(frame.Joints.ToArray()).And.Some.Not.EqualTo(0));
        Assert.That(_session.Displayed(), Is.Null, "the same frame again");
    }

    [Test, Order(3)]
    public void Displayed_ReadDuringFrames_DoesNotAllocateOnTheFrameThread()
    {
        var now = HeadsetTime.FromSeconds(20);
        for (var i = 0; i < 200; i++) Frame(now += TimeSpan.FromMilliseconds(16));
        WaitOnceForTheSession(now);
        var displayed = 0;
        using var stop = new CancellationTokenSource();
        var background = Task.Run(() =>
        {
            while (!stop.IsCancellationRequested)
            {
                if (_session.Displayed() != null) Interlocked.Increment(ref displayed);
                // Pauses between readings. Taking the session's lock without a pause would block the frames.
                Thread.Sleep(1);
            }
        });
        var allocated = 0L;
        // On a busy machine, the other thread can start late.
        for (var i = 0; i < 2000 || Volatile.Read(ref displayed) == 0 && !background.IsCompleted; i++)
        {
            Feed(now += TimeSpan.FromMilliseconds(16));
            var before = GC.GetAllocatedBytesForCurrentThread();
            _session.Tick(now);
            allocated += GC.GetAllocatedBytesForCurrentThread() - before;
        }

        stop.Cancel();
        background.Bounded().GetAwaiter().GetResult();

        Assert.That(allocated, Is.EqualTo(0));
        Assert.That(displayed, Is.GreaterThan(0));
    }

    // The runtime allocates a wait object when a thread waits for a lock for the first time. This does not count as a cost of a frame.
    void WaitOnceForTheSession(HeadsetTime now)
    {
        var (waiting, isHeld, isAtTheLock) = (Thread.CurrentThread, new ManualResetEventSlim(), new ManualResetEventSlim());
        void Hold(DisplayFrame frame)
        {
            isHeld.Set();
            Assert.That(SpinWait.SpinUntil(() => isAtTheLock.IsSet && waiting.ThreadState.HasFlag(ThreadState.WaitSleepJoin), Soon.Limit), Is.True);
        }

        _session.Ticked += Hold;
        var holding = Task.Factory.StartNew(() => _session.Tick(now), TaskCreationOptions.LongRunning);
        Assert.That(SpinWait.SpinUntil(() => isHeld.IsSet, Soon.Limit), Is.True);
        // Sets the event only now, because SpinUntil itself sleeps, which would count as waiting for the lock.
        isAtTheLock.Set();
        _session.Displayed();
        _session.Ticked -= Hold;
        holding.Bounded().GetAwaiter().GetResult();
    }

    void Frame(HeadsetTime now)
    {
        Feed(now);
        _session.Tick(now);
    }

    void Feed(HeadsetTime now)
    {
        var control = new ControlTime(now.SinceEpoch);
        _session.Clock.Add(new SyncExchange(now, control, control, now), out _);
        _session.Listener.Received(Sample(now), now);
    }

    JointStateMessage Sample(HeadsetTime now) => new(
        new ControlTime(now.SinceEpoch) - TimeSpan.FromMilliseconds(80), [.. _session.Robot.MovingJoints.Select(joint => joint.Name)],
        [.. _session.Robot.MovingJoints.Select((_, i) => 0.01 * Math.Sin(now.SinceEpoch.TotalSeconds + i))]);
}
