using System.Text;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Sync;
using Nowpose.Sync.Ransac;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Network;

/// <summary>Tests a link whose sends do not complete, as with a full buffer after the other side has disappeared.</summary>
[Parallelizable(ParallelScope.All)]
public class StuckSendTests
{
    const string Text = """{"op":"publish","topic":"/joint_states","msg":{"header":{"stamp":{"secs":5,"nsecs":0}},"name":["a"],"position":[1]}}""";

    /// <summary>Number of messages, higher than the number that is sent within two seconds.</summary>
    const int ForTwoSeconds = 45;

    /// <summary>Number of subscriptions and advertisements, which are sent first.</summary>
    const int AtTheBeginning = 6;

    // Both limits are 6 s and are reached at the same time, so either reason is correct.
    static readonly object[][] Stuck =
    [
        [0, false, false, new[] { ConnectionMessages.NothingSent(6), ConnectionMessages.NothingReceived(6) }],
        [ForTwoSeconds, false, false, new[] { ConnectionMessages.NothingReceived(6) }],
        [AtTheBeginning, true, false, new[] { ConnectionMessages.NothingSent(6) }],
        [AtTheBeginning, true, true, new[] { ConnectionMessages.NoAnswer("/rosapi/get_time", 2) }],
    ];

    [TestCaseSource(nameof(Stuck))]
    public async Task Send_NeverCompletes_EndsTheConnectionAndReconnects(int taken, bool receives, bool asksTime, string[] reasons)
    {
        var clock = new StopwatchHeadsetClock();
        var exchanges = asksTime ? Exchanges(clock) : null;
        var links = 0;
        // The second link never opens, so that its status does not replace the reason why the first one ended.
        IWebSocketLink Next() => Interlocked.Increment(ref links) == 1 ? new StuckLink(clock, taken, receives) : new NeverOpeningLink();

        using var client = new RosbridgeClient(Next, clock, new Listener(), Subscribed.ToRobot(), true, exchanges);

        await Soon.BecomesAsync(() => Volatile.Read(ref links) > 1, "another connection");
        Assert.That(reasons.Where(client.Status.Detail.Contains), Is.Not.Empty, client.Status.Detail);
        client.Dispose();
        await client.Ended.Bounded();
    }

    static RosTimeExchanges Exchanges(IHeadsetClock clock) => new(
        clock, new ClockSynchroniser(new RansacClockEstimator(RansacSettings.Paper), ClockSettings.Default), new SyncFaultCounters(),
        new ExchangePace(TimeSpan.FromMilliseconds(200), TimeSpan.FromSeconds(5), new Random(1)));

    sealed class StuckLink(IHeadsetClock clock, int taken, bool receives) : IWebSocketLink
    {
        static readonly TimeSpan Interval = TimeSpan.FromMilliseconds(100);

        readonly TaskCompletionSource _gone = new(TaskCreationOptions.RunContinuationsAsynchronously);
        int _sent;

        public Task OpenAsync(CancellationToken cancel) => Task.CompletedTask;

        public Task SendAsync(string text, CancellationToken cancel) =>
            Interlocked.Increment(ref _sent) <= taken ? Task.CompletedTask : new TaskCompletionSource().Task;

        public async Task<string> ReceiveAsync(Action<ReceivedText> take, CancellationToken cancel)
        {
            while (true)
            {
                if (!receives) await _gone.Task;
                await Task.Delay(Interval, cancel);
                take(ReceivedText.Message(Encoding.UTF8.GetBytes(Text), clock.Now));
            }
        }

        public void Dispose() => _gone.TrySetException(new ObjectDisposedException(nameof(StuckLink)));
    }

    sealed class NeverOpeningLink : IWebSocketLink
    {
        public Task OpenAsync(CancellationToken cancel) => Task.Delay(Timeout.Infinite, cancel);
        public Task SendAsync(string text, CancellationToken cancel) => throw new NotSupportedException();
        public Task<string> ReceiveAsync(Action<ReceivedText> take, CancellationToken cancel) => throw new NotSupportedException();
        public void Dispose() { }
    }

    sealed class Listener : IRosbridgeListener
    {
        public void Received(JointStateMessage message, HeadsetTime arrival, string robot) { }
        public void Planned(JointTrajectoryMessage message, HeadsetTime arrival, string robot) { }
        public void FramesReceived(TransformsMessage message, bool isStationary, HeadsetTime arrival) { }
        public void SignalsReceived(SignalsMessage message, HeadsetTime arrival) { }
        public void StatusReceived(JointStatusMessage message, HeadsetTime arrival) { }
        public void Connected(HeadsetTime at) { }
        public void VersionReceived(string version) { }
        public void SignalStatusReceived(JointStatusMessage message, HeadsetTime arrival) { }
        public void Described(string urdf, string robot) { }
        public void Dropped(DropReason reason) { }
        public DiagnosticsMessage Diagnostics() => null;
        public bool HasPoseChanged => false;
        public bool NeedsNamespaces => false;
        public void NamespacesReceived(IReadOnlyList<string> names) { }
        public JointStateMessage Displayed() => new(ControlTime.FromSeconds(5), ["a"], [0.5]);
    }
}
