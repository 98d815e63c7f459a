using System.Diagnostics;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Status.Events;
using Nowpose.Protocol;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Clock;

/// <summary>Tests of two clients that offer clocks of the same name.</summary>
public class ClockNameTests
{
    static readonly ControlTime PlantStart = ControlTime.FromSeconds(900_000);
    static readonly TimeSpan Ahead = TimeSpan.FromMilliseconds(400);

    [Test]
    public async Task JointState_OtherClockOfTheSameName_IsConvertedWithTheTimesOfItsClient()
    {
        var served = new StopwatchControlClock(PlantStart + Ahead);
        var other = new StopwatchControlClock(PlantStart);

        var error = await StampErrorAsync(served, other);

        Assert.That(error.Duration(), Is.LessThan(Ahead / 4));
    }

    [Test]
    public async Task JointState_SameClockOfferedTwice_KeepsItsStamp()
    {
        var shared = new StopwatchControlClock(PlantStart);

        var error = await StampErrorAsync(shared, shared);

        Assert.That(error.Duration(), Is.LessThan(Ahead / 4));
    }

    [Test]
    public async Task Events_OtherClockOfTheSameName_NameBothClientsUntilOneLeaves()
    {
        await using var gateway = await Gateways.StartAsync();
        using var first = await ServedAsync(gateway, new StopwatchControlClock(PlantStart + Ahead));
        using (await PlantAdapterDouble.ConnectAsync(gateway, "plc", new StopwatchControlClock(PlantStart)))
            await Soon.BecomesAsync(() => Present(gateway).Any(), "the different times are reported");

        await Soon.BecomesAsync(() => !Present(gateway).Any(), "the other client has left");
        Assert.That(gateway.Events.Read().Single(IsOfName).Condition.Reason, Does.Match(@"the clock of rosbridge 127\.0\.0\.1 is \d+\.\d ms behind that of rosbridge 127\.0\.0\.1"));
    }

    [Test]
    public async Task Events_SameClockOfferedTwice_AreNone()
    {
        var shared = new StopwatchControlClock(PlantStart);
        await using var gateway = await Gateways.StartAsync();
        using var first = await ServedAsync(gateway, shared);
        using var second = await PlantAdapterDouble.ConnectAsync(gateway, "plc", shared);

        await Soon.BecomesAsync(() => second.Requests > 20, "the clock of the second client is measured");

        Assert.That(gateway.Events.Read().Where(IsOfName), Is.Empty);
    }

    [TestCase(0.0, true)]
    [TestCase(0.4, false)]
    public void TryAttach_AfterThePreviousAdapter_KeepsTheEstimateOnlyOfTheSameClock(double aheadSeconds, bool isKept)
    {
        var counter = new SteppedClock();
        var clocks = new PlantClocks(null, counter);
        var (served, measured) = (clocks.Find("plc"), new PlantClock("plc", counter));
        for (var i = 0; i < 50; i++)
        {
            counter.Set(i * 0.1);
            Exchange(served, counter.Read, 0);
            Exchange(measured, counter.Read, aheadSeconds);
        }

        using var caller = new PlantClockCaller(served, counter, TimeProvider.System, _ => { });
        served.TryAttach(caller, measured);

        Assert.That(served.Model.IsKnown, Is.EqualTo(isKept));
    }

    static void Exchange(PlantClock clock, HeadsetTime now, double aheadSeconds)
    {
        var time = ControlTime.FromSeconds(now.SinceEpoch.TotalSeconds + 900_000 + aheadSeconds);
        var half = TimeSpan.FromMilliseconds(0.2);
        clock.Add(new SyncExchange(now - half, time, time, now + half, TimeSpan.Zero, TimeSpan.Zero, true));
    }

    // Returns the error of the stamp with which the gateway publishes a sample of the second client, on the clock of the first one.
    static async Task<TimeSpan> StampErrorAsync(StopwatchControlClock served, StopwatchControlClock other)
    {
        await using var gateway = await Gateways.StartAsync();
        using var first = await ServedAsync(gateway, served);
        using var second = await PlantAdapterDouble.ConnectAsync(gateway, "plc", other);
        using var headset = await RawRosbridgeClient.ConnectAsync(gateway);
        await headset.SubscribeAsync(RosTopics.JointStates);
        await Soon.BecomesAsync(() => second.Requests > 20, "the clock of the second client is measured");

        var count = Stopwatch.GetTimestamp();
        var state = new JointStateMessage(other.AtCount(count), ["a"], [0.5]);
        await second.Client.SendAsync(RosbridgeWriter.Publish(RosTopics.JointStates, state, RosTimeForm.Sec));

        return (await headset.ReceiveAsync()).JointState.Stamp - served.AtCount(count);
    }

    static async Task<PlantAdapterDouble> ServedAsync(GatewayServer gateway, StopwatchControlClock clock)
    {
        var adapter = await PlantAdapterDouble.ConnectAsync(gateway, "plc", clock);
        await Soon.BecomesAsync(() => gateway.Clock.State == ClockState.Synchronised && gateway.Clock.Source == "plc", "the first clock is served");
        return adapter;
    }

    static IEnumerable<StatusEvent> Present(GatewayServer gateway) => gateway.Events.Read().Where(one => one.Until == null && IsOfName(one));

    static bool IsOfName(StatusEvent one) => one.Condition is { Kind: "clock", Which: "plc", Level: Level.Error, Blocks: false };
}
