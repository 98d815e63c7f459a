using System.Collections.Concurrent;
using NUnit.Framework;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Plants;
using Nowpose.Motion;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Simulation.Work;

namespace Nowpose.Headless.Tests.Gateway;

public class SimulatedCellTests
{
    static readonly CellTiming Timing = new(TimeSpan.FromMilliseconds(10), TimeSpan.FromMilliseconds(20), TimeSpan.FromMilliseconds(40));

    [Test]
    public async Task Publish_RealTime_SendsTruePositionsAtTheStampAfterTheDelay()
    {
        var clock = new StopwatchControlClock(ControlTime.FromSeconds(50), 100e-6);
        await using var gateway = await Gateways.StartAsync(clock: clock);
        var published = new ConcurrentDictionary<ControlTime, ControlTime>();
        using var listening = gateway.Hub.Subscribe(RosTopics.JointStates, message => published[((JointStateMessage)message.Content).Stamp] = clock.Now);
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates, null, 0, 100);
        var motion = new PickAndPlaceMotion(RobotFiles.Load("youbot"));
        using var cell = new SimulatedCell(new CellMotion(motion), clock, Timing, 1);

        cell.PublishInto(gateway.Hub);

        var truth = new double[motion.JointNames.Count];
        var samples = new List<JointStateMessage>();
        for (var i = 0; i < 50; i++)
        {
            samples.Add((await client.ReceiveAsync()).JointState);
            Assert.That(samples[i].Names, Is.EqualTo(motion.JointNames));
            cell.TruthAt(samples[i].Stamp, truth);
            Assert.That(samples[i].Positions, Is.EqualTo(truth));
        }

        // On a busy machine a pause may be longer than samples are kept, so some samples may be missing. The others keep their intervals.
        var intervals = samples.Zip(samples.Skip(1), (a, b) => b.Stamp - a.Stamp).ToList();
        Assert.That(intervals, Is.Not.Empty.And.All.GreaterThan(TimeSpan.Zero));
        Assert.That(intervals.Select(interval => interval.Ticks % Timing.SamplingInterval.Ticks), Is.Not.Empty.And.All.Zero);
        // Only the minimum delay is asserted: samples are never sent early, but a busy machine may send them late.
        Assert.That(samples.Select(sample => (published[sample.Stamp] - sample.Stamp).TotalMilliseconds), Has.All.GreaterThanOrEqualTo(20));
    }

    [Test]
    public async Task Publish_ClockAdvancesWithEachReading_SendsEachSampleAfterItsDelay()
    {
        var clock = new LookedAtClock();
        var delays = new ConcurrentQueue<double>();
        var hub = new MessageHub();
        using var listening = hub.Subscribe(
            RosTopics.JointStates, message => delays.Enqueue((clock.Now - ((JointStateMessage)message.Content).Stamp).TotalMilliseconds));
        using var cell = new SimulatedCell(new CellMotion(new PickAndPlaceMotion(RobotFiles.Load("ur5"))), clock, Timing, 1);

        cell.PublishInto(hub);

        await Soon.BecomesAsync(() => delays.Count >= 50, "50 samples");
        Assert.That(delays.Min(), Is.InRange(20, 26));
        Assert.That(delays.Max(), Is.InRange(37, 46));
    }

    [Test]
    public void TruthAt_TimeBeforeTheStart_IsTheHomePosition()
    {
        var clock = new StopwatchControlClock(ControlTime.FromSeconds(50));
        var motion = new PickAndPlaceMotion(RobotFiles.Load("youbot"));
        using var cell = new SimulatedCell(new CellMotion(motion), clock, Timing, 1);
        var home = new double[motion.JointNames.Count];
        var before = new double[motion.JointNames.Count];
        motion.At(0, home);

        cell.TruthAt(cell.Start - TimeSpan.FromSeconds(10), before);

        Assert.That(before, Is.EqualTo(home));
    }

    [Test]
    public async Task PublishInto_SecondHub_ContinuesWithNewSamples()
    {
        var clock = new LookedAtClock();
        using var cell = new SimulatedCell(new CellMotion(new PickAndPlaceMotion(RobotFiles.Load("ur5"))), clock, Timing, 1);
        await SampleOf(cell, new MessageHub());
        clock.Advance(TimeSpan.FromSeconds(10));
        var restarted = clock.Now;

        var stamp = await SampleOf(cell, new MessageHub());

        Assert.That(stamp, Is.GreaterThan(restarted - Timing.AcquisitionMax), "samples that were due without a hub are skipped");
    }

    [Test]
    public async Task PublishInto_CellWithWork_PublishesObjectsAndSignals()
    {
        var robot = RobotFiles.Load("youbot", out var urdf);
        var work = new CellWork(robot, new PickAndPlaceMotion(robot));
        using var cell = new SimulatedCell(new CellMotion(work), new LookedAtClock(), Timing, 1);
        var frames = new ConcurrentQueue<HubMessage>();
        // Publishes into another hub first. The second hub represents a restarted gateway and must also receive the stationary frames and all
        // signals.
        await SampleOf(cell, new MessageHub());
        var hub = new MessageHub();
        using var description = hub.OpenSource();
        description.Describe(urdf);
        using var tracked = hub.Subscribe(RosTopics.Tf, frames.Enqueue);
        using var signals = hub.Subscribe(RosTopics.Signals, frames.Enqueue);
        using var stationary = hub.Subscribe(RosTopics.TfStatic, frames.Enqueue);

        cell.PublishInto(hub);

        await Soon.BecomesAsync(() => frames.Count >= 20, "objects and signals");
        var poses = frames.Where(message => message.Topic == RosTopics.Tf).Select(message => (TransformsMessage)message.Content).ToList();
        foreach (var pose in poses)
            for (var i = 0; i < pose.Count; i++)
            {
                var expected = work.PoseOf(i, (pose[i].Stamp - cell.Start).TotalSeconds, out var parent);
                Assert.That((pose[i].Child, pose[i].Parent), Is.EqualTo((work.Names[i], parent)));
                Assert.That(new[] { pose[i].X, pose[i].Y, pose[i].Z }, Is.EqualTo(new[] { expected.X, expected.Y, expected.Z }).Within(1e-9));
            }
        Assert.That(poses, Is.Not.Empty);
        Assert.That(Children(frames, RosTopics.TfStatic), Is.EquivalentTo(new[] { CellWork.Conveyor, "fixture" }));
        var values = frames.Where(message => message.Topic == RosTopics.Signals).Select(message => (SignalsMessage)message.Content);
        Assert.That(values.SelectMany(message => Enumerable.Range(0, message.Count).Select(i => message[i].Name)), Is.SupersetOf(work.Signals));
    }

    [Test]
    public async Task PublishInto_TwoRobots_PublishesBothWithTheirBases()
    {
        var robot = RobotFiles.Load("youbot", out var urdf);
        var work = new CellWork(robot, new PickAndPlaceMotion(robot), 2);
        using var cell = new SimulatedCell(new CellMotion(work), new LookedAtClock(), Timing, 1, publishesPlan: true);
        var messages = new ConcurrentQueue<HubMessage>();
        var hub = new MessageHub();
        using var description = hub.OpenSource();
        foreach (var each in work.Robots) Assert.That(description.Describe(urdf, each.Namespace), Is.Null);
        using var listening = new Subscriptions(
            new[] { "/arm1/joint_states", "/arm2/joint_states", "/arm2/joint_trajectory", RosTopics.Tf, RosTopics.TfStatic }
                .Select(topic => hub.Subscribe(topic, messages.Enqueue)));

        cell.PublishInto(hub);

        await Soon.BecomesAsync(() => messages.Select(message => message.Topic).Distinct().Count() == 5, "all topics");
        await Soon.BecomesAsync(() => messages.Count >= 30, "some samples");
        Assert.That(Children(messages, RosTopics.TfStatic), Has.Member("arm2/arm_link_0").And.Member("fixture_2"));
        Assert.That(Children(messages, RosTopics.Tf).Distinct(), Is.EquivalentTo(work.Names));
        foreach (var (name, motion) in work.Motions)
        {
            var samples = messages.Where(message => message.Topic == $"/{name}/joint_states").ToList();
            var expected = new double[motion.JointNames.Count];
            foreach (var sample in samples.Select(message => (JointStateMessage)message.Content))
            {
                motion.At((sample.Stamp - cell.Start).TotalSeconds, expected);
                Assert.That(sample.Positions, Is.EqualTo(expected), name);
            }
            Assert.That(samples, Is.Not.Empty);
        }
    }

    sealed class Subscriptions(IEnumerable<IDisposable> all) : IDisposable
    {
        readonly List<IDisposable> _all = [.. all];

        public void Dispose() => _all.ForEach(one => one.Dispose());
    }

    static IEnumerable<string> Children(IEnumerable<HubMessage> messages, string topic) => messages
        .Where(message => message.Topic == topic).Select(message => (TransformsMessage)message.Content)
        .SelectMany(message => Enumerable.Range(0, message.Count).Select(i => message[i].Child));

    /// <summary>A clock that advances by a millisecond with each reading. Pauses of a busy machine between readings have no effect on it.</summary>
    sealed class LookedAtClock : IControlClock
    {
        long _milliseconds;

        public ControlTime Now => ControlTime.FromSeconds(50) + TimeSpan.FromMilliseconds(Interlocked.Increment(ref _milliseconds));

        public void Advance(TimeSpan by) => Interlocked.Add(ref _milliseconds, (long)by.TotalMilliseconds);
    }

    /// <summary>Publishes into a hub until the first sample arrives, and returns its stamp.</summary>
    static async Task<ControlTime> SampleOf(SimulatedCell cell, MessageHub hub)
    {
        var arrived = new TaskCompletionSource<ControlTime>(TaskCreationOptions.RunContinuationsAsynchronously);
        using var listening = hub.Subscribe(RosTopics.JointStates, message => arrived.TrySetResult(((JointStateMessage)message.Content).Stamp));
        cell.PublishInto(hub);
        return await arrived.Task.Bounded();
    }
}
