using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Faults;

/// <summary>Tests a headset when the gateway or the source ends without notice, or when the control clock steps.</summary>
public class EndpointFaultTests
{
    static readonly string[] Joints = ["arm_joint_1", "arm_joint_2", "arm_joint_3", "arm_joint_4", "arm_joint_5"];

    [Test]
    public async Task Gateway_KilledAndRestarted_HeadsetShowsTheFaultAndRecovers()
    {
        using ReservedPort sync = new(), positions = new();
        using var first = await SimulateAsync(sync.Port, positions.Port);
        using var headset = new FaultHeadset(sync.Port, positions.Port);
        await headset.BecomesAsync(PoseState.Current);

        await first.SignalAsync("KILL");
        await headset.BecomesAsync(() => headset.State != PoseState.Current, "no longer shown as current");
        using var second = await SimulateAsync(sync.Port, positions.Port);
        var took = await headset.BecomesAsync(PoseState.Current);

        Recovery.Print("gateway process killed and started again, from serving to a current pose", took);
    }

    [Test]
    public async Task Source_Killed_HeadsetHoldsThePoseUntilTheNextSource()
    {
        var clock = new StopwatchControlClock(Gateways.Start);
        await using var gateway = await Gateways.StartAsync(clock: clock);
        using var headset = new FaultHeadset(gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port);
        using (var plant = await RawRosbridgeClient.ConnectAsync(gateway))
        {
            using var publishing = new CancellationTokenSource();
            var published = PublishAsync(plant, clock, publishing.Token);
            await headset.BecomesAsync(PoseState.Current);
            await publishing.CancelAsync();
            await published;
            // Ends the connection without a close frame, like a killed process.
            plant.Socket.Abort();
        }

        await headset.BecomesAsync(PoseState.Held);
        await Soon.BecomesAsync(() => gateway.WebSocketConnections.Open == 1, "the source has disconnected");
        using var next = await RawRosbridgeClient.ConnectAsync(gateway);
        using var stop = new CancellationTokenSource();
        var going = PublishAsync(next, clock, stop.Token);
        var took = await headset.BecomesAsync(PoseState.Current);
        await stop.CancelAsync();
        await going;

        Recovery.Print("plant killed, from the next one's connection to a current pose", took);
        Assert.That(gateway.Drops[DropReason.JointTaken], Is.Zero, "the joints no longer belonged to another source");
    }

    [TestCase(1.0)]
    [TestCase(-1.0)]
    [TestCase(-0.1)]
    public async Task ControlClock_Stepped_HeadsetDetectsAndFollowsTheStep(double seconds)
    {
        var clock = new SteppingClock();
        await using var gateway = await Gateways.StartAsync(clock: clock);
        var cell = FaultCell.In(gateway.Hub, clock);
        using var headset = new FaultHeadset(gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port);
        await headset.BecomesAsync(PoseState.Current);
        cell.Dispose();

        clock.Step(TimeSpan.FromSeconds(seconds));
        using var after = FaultCell.In(gateway.Hub, clock);
        var took = await headset.BecomesAsync(() => headset.Session.Clock.Steps > 0 && headset.IsClockCorrect(clock), "detected and corrected");

        Recovery.Print($"control clock stepped by {seconds:+0;-0} s", took);
        await headset.BecomesAsync(PoseState.Current);
    }

    static async Task<PeerProcess> SimulateAsync(int sync, int positions)
    {
        var gateway = new PeerProcess(
            "Nowpose.Gateway.dll", "simulate", "--sync-port", sync.ToString(), "--ws-port", positions.ToString(), "--acquisition-ms", "10-20");
        await gateway.PrintsAsync("state serving");
        return gateway;
    }

    static async Task PublishAsync(RawRosbridgeClient plant, StopwatchControlClock clock, CancellationToken stop)
    {
        while (!stop.IsCancellationRequested)
        {
            var angle = 0.3 * Math.Sin(clock.Now.SinceEpoch.TotalSeconds);
            var state = new JointStateMessage(clock.Now, Joints, [.. Joints.Select(_ => 0.5 + angle)]);
            await plant.SendAsync(RosbridgeWriter.Publish(RosTopics.JointStates, state, RosTimeForm.Sec));
            await Task.WhenAny(Task.Delay(40, stop));
        }
    }

    sealed class SteppingClock : IControlClock
    {
        readonly StopwatchControlClock _clock = new(Gateways.Start);
        long _stepTicks;

        public ControlTime Now => _clock.Now + new TimeSpan(Interlocked.Read(ref _stepTicks));
        public TimeSpan Resolution => _clock.Resolution;
        public void Step(TimeSpan by) => Interlocked.Add(ref _stepTicks, by.Ticks);
    }
}
