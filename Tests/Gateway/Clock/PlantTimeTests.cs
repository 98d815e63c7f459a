using System.Diagnostics;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Clock;

/// <summary>Tests, over real sockets, that the gateway serves the clock of a control system that an adapter offers.</summary>
public class PlantTimeTests
{
    static readonly ControlTime PlantStart = ControlTime.FromSeconds(900_000);

    [Test]
    public async Task PlantTime_OfferedByAnAdapter_IsServedAsControlTimeWithItsErrorBound()
    {
        var plc = new StopwatchControlClock(PlantStart, 80e-6);
        await using var gateway = await Gateways.StartAsync();
        using var adapter = await PlantAdapterDouble.ConnectAsync(gateway, "plc", plc, ",\"error_bound_ns\":300000");

        await Soon.BecomesAsync(() => gateway.Clock.IsSynchronised && gateway.Clock.Source == "plc", "the plant's clock is served");

        using var headset = await RawSyncClient.ConnectAsync(gateway);
        var before = plc.Now;
        var reply = (await headset.ExchangeAsync(SyncFrame.Request(1, 42))).Value;
        var after = plc.Now;
        var bound = TimeSpan.FromMicroseconds(reply.ErrorBoundUs);
        Assert.That(reply.IsServerSynchronised, Is.True);
        Assert.That(bound, Is.GreaterThan(TimeSpan.FromMicroseconds(300)), "the bound contains that of the plant");
        Assert.That(ControlTime.FromNanoseconds(reply.T2Ns), Is.InRange(before - bound, after + bound));
        Assert.That(reply.T3Ns, Is.GreaterThanOrEqualTo(reply.T2Ns));
        Assert.That(reply.ResolutionNs, Is.EqualTo(100u));
    }

    [Test]
    public async Task SyncReply_SelectedClockNotOfferedYet_IsNotSynchronised()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { ControlClock = "plc" });
        using var headset = await RawSyncClient.ConnectAsync(gateway);
        using var other = await PlantAdapterDouble.ConnectAsync(gateway, "other", new StopwatchControlClock(PlantStart));
        await Soon.BecomesAsync(() => StatusOf(gateway, "other")?.State == ClockState.Synchronised, "the other clock is known");

        var reply = await headset.ExchangeAsync(SyncFrame.Request(1, 42));

        Assert.That(reply.Value.IsServerSynchronised, Is.False);
        Assert.That(gateway.Clock.Source, Is.EqualTo("plc"));
    }

    [Test]
    public async Task PlantTime_OwnClockSelected_IsOnlyCompared()
    {
        var own = new StopwatchControlClock(Gateways.Start);
        var plc = new StopwatchControlClock(Gateways.Start + TimeSpan.FromSeconds(3));
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { ControlClock = PlantClocks.Own }, own);
        using var adapter = await PlantAdapterDouble.ConnectAsync(gateway, "plc", plc);

        await Soon.BecomesAsync(() => StatusOf(gateway, "plc")?.State == ClockState.Synchronised, "the plant's clock is known");

        var count = Stopwatch.GetTimestamp();
        var truth = plc.AtCount(count) - own.AtCount(count);
        // If the thread is interrupted between its readings of the two clocks, their difference contains the pause.
        bool IsRight(PlantClockStatus status) =>
            (status.OffsetToControl.Value - truth).Duration() <= status.ErrorBound + TimeSpan.FromMilliseconds(1);
        await Soon.BecomesAsync(
            () => IsRight(StatusOf(gateway, "plc")), () => $"{truth.TotalSeconds} s ahead; the status is {StatusOf(gateway, "plc")}");
        var before = own.Now;
        var served = gateway.Clock.Now;
        Assert.That(served, Is.InRange(before, own.Now));
    }

    [Test]
    public async Task JointState_TimeStampOfASecondPlantClock_IsConvertedToControlTime()
    {
        var ads = new StopwatchControlClock(PlantStart);
        var opcua = new StopwatchControlClock(PlantStart + TimeSpan.FromSeconds(2));
        await using var gateway = await Gateways.StartAsync();
        using var first = await ConnectedAsync(gateway, "ads", ads);
        using var second = await ConnectedAsync(gateway, "opcua", opcua);
        using var headset = await RawRosbridgeClient.ConnectAsync(gateway);
        await headset.SubscribeAsync(RosTopics.JointStates);

        var count = Stopwatch.GetTimestamp();
        var state = new JointStateMessage(opcua.AtCount(count), ["a"], [0.5]);
        // The bounds at this moment may be smaller than the bounds at the time of the conversion.
        var bound = StatusOf(gateway, "ads").ErrorBound + StatusOf(gateway, "opcua").ErrorBound;
        await second.Client.SendAsync(RosbridgeWriter.Publish(RosTopics.JointStates, state, RosTimeForm.Sec));

        var error = (await headset.ReceiveAsync()).JointState.Stamp - ads.AtCount(count);
        Assert.That(error.Duration(), Is.LessThanOrEqualTo(bound + TimeSpan.FromMilliseconds(10)));
        Assert.That(bound, Is.LessThan(TimeSpan.FromSeconds(1)), "the two clocks differ by 2 s");
    }

    [TestCase("ads")]
    [TestCase("opcua")]
    public async Task JointState_TimeStampAheadOfTheClockThatTheSourceOffers_ContradictsTheClock(string name)
    {
        await using var gateway = await Gateways.StartAsync();
        using var first = await ConnectedAsync(gateway, "ads", new StopwatchControlClock(PlantStart));
        var opcua = new StopwatchControlClock(PlantStart + TimeSpan.FromSeconds(2));
        using var second = await ConnectedAsync(gateway, "opcua", opcua);
        var (source, start) = name == "ads" ? (first, opcua.Now - TimeSpan.FromSeconds(2)) : (second, opcua.Now);

        for (var i = 0; i < StampWatch.MinSamples; i++)
        {
            var state = new JointStateMessage(start + TimeSpan.FromSeconds(60 + i), ["a"], [0.5]);
            await source.Client.SendAsync(RosbridgeWriter.Publish(RosTopics.JointStates, state, RosTimeForm.Sec));
        }

        await Soon.BecomesAsync(() => gateway.Clock.Stamps.IsContradicted, () => gateway.Clock.Stamps.Warning ?? "no contradiction");
        Assert.That(gateway.Clock.Stamps.Found.Remedy, Is.EqualTo(StampMessages.SourceRemedy));
    }

    [Test]
    public async Task JointState_ClockNotMeasuredYet_IsRefusedWithAStatus()
    {
        await using var gateway = await Gateways.StartAsync();
        using var adapter = await PlantAdapterDouble.ConnectAsync(gateway, "plc", (_, _) => null);
        await Soon.BecomesAsync(() => StatusOf(gateway, "plc") != null, "the clock is offered");

        await adapter.Client.SendAsync(Gateways.StateText(0.5));

        await Soon.BecomesAsync(() => gateway.Drops[DropReason.Unsynchronised] == 1, "the sample is dropped");
    }

    [Test]
    public async Task PlantTime_AdapterReconnects_KeepsItsEstimate()
    {
        var plc = new StopwatchControlClock(PlantStart);
        await using var gateway = await Gateways.StartAsync();
        using (await PlantAdapterDouble.ConnectAsync(gateway, "plc", plc))
            await Soon.BecomesAsync(() => gateway.Clock.Source == "plc" && gateway.Clock.State == ClockState.Synchronised, "the clock is known");

        await Soon.BecomesAsync(() => gateway.Clock.State == ClockState.Holdover, "the clock is in holdover");
        var isServed = gateway.Clock.IsSynchronised;
        var before = plc.Now;
        var served = gateway.Clock.Now;
        var after = plc.Now;
        var bound = gateway.Clock.ErrorBound;
        using var back = await PlantAdapterDouble.ConnectAsync(gateway, "plc", plc);
        await Soon.BecomesAsync(() => gateway.Clock.State == ClockState.Synchronised, "the clock is measured again");

        Assert.That(isServed, Is.True, "the clock is served during a holdover of some seconds");
        Assert.That(served, Is.InRange(before - bound, after + bound));
        Assert.That(bound, Is.LessThan(TimeSpan.FromSeconds(1)), "a larger bound would accept any served time");
        Assert.That(gateway.PlantClocks.All, Has.Count.EqualTo(1));
    }

    [Test]
    public async Task PlantTime_OfferWithdrawn_IsNotRequestedAgain()
    {
        await using var gateway = await Gateways.StartAsync();
        using var adapter = await PlantAdapterDouble.ConnectAsync(gateway, "plc", new StopwatchControlClock(PlantStart));
        using var other = await PlantAdapterDouble.ConnectAsync(gateway, "other", new StopwatchControlClock(PlantStart));
        await Soon.BecomesAsync(() => adapter.Requests > 3, "the clock is requested");

        await adapter.WithdrawAsync();

        await Soon.BecomesAsync(() => !StatusOf(gateway, "plc").IsConnected, "the clock has no connected adapter");
        // One request may still be on its way to the adapter.
        await RequestedFiveTimesAsync(other);
        var asked = adapter.Requests;
        await RequestedFiveTimesAsync(other);
        Assert.That(adapter.Requests, Is.EqualTo(asked));
    }

    [TestCase("/nowpose/plant_time/Two Words")]
    [TestCase("/nowpose/plant_time/own")]
    [TestCase("/nowpose/plant_time/")]
    [TestCase("/rosapi/get_time")]
    public async Task AdvertiseService_OtherService_IsRefused(string service)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync($$"""{"op":"advertise_service","service":"{{service}}","type":"nowpose/PlantTime"}""");

        await client.ExpectErrorAsync(nameof(DropReason.UnknownService));
        Assert.That(gateway.PlantClocks.All, Is.Empty);
    }

    [Test]
    public async Task AdvertiseService_ClockOfAnotherClient_IsRefused()
    {
        await using var gateway = await Gateways.StartAsync();
        using var adapter = await PlantAdapterDouble.ConnectAsync(gateway, "plc", new StopwatchControlClock(PlantStart));
        await Soon.BecomesAsync(() => StatusOf(gateway, "plc")?.IsConnected == true, "the clock is offered");
        using var second = await RawRosbridgeClient.ConnectAsync(gateway);

        await second.SendAsync("""{"op":"advertise_service","service":"/nowpose/plant_time/plc","type":"nowpose/PlantTime"}""");

        // The first request for the time may arrive before the refusal.
        var message = await second.ReceiveAsync();
        if (message.Op == RosbridgeOp.CallService) message = await second.ReceiveAsync();
        Assert.That((message.Op, message.Level), Is.EqualTo((RosbridgeOp.Status, "error")));
        Assert.That(message.Text, Does.Contain(DropMessages.Of(DropReason.JointTaken)));
    }

    [Test]
    public async Task AdvertiseService_PreviousConnectionSilent_NewConnectionTakesOverTheClock()
    {
        var plc = new StopwatchControlClock(PlantStart);
        var isGone = false;
        await using var gateway = await Gateways.StartAsync();
        using var lost = await PlantAdapterDouble.ConnectAsync(
            gateway, "plc", (id, service) => Volatile.Read(ref isGone) ? null : PlantAdapterDouble.AnswerOf(id, service, plc.Now, plc.Now));
        await Soon.BecomesAsync(() => StatusOf(gateway, "plc")?.State == ClockState.Synchronised, "the clock is known");
        using var back = await PlantAdapterDouble.ConnectAsync(gateway, "plc", plc);
        await Soon.BecomesAsync(() => gateway.Drops[DropReason.JointTaken] == 1, "the second client is refused while the first one responds");
        // As with a broken cable, the first connection stays open but sends no message.
        Volatile.Write(ref isGone, true);
        var before = StatusOf(gateway, "plc").Exchanges;

        await Soon.BecomesAsync(() =>
        {
            // The new connection takes over the clock at its next message. Adapters send their state every second, but any message is sufficient.
            back.Client.SendAsync("{\"op\":\"status\",\"level\":\"none\",\"msg\":\"\"}").GetAwaiter().GetResult();
            return StatusOf(gateway, "plc").Exchanges > before + 5;
        }, "the clock is requested on the new connection");

        Assert.That(gateway.Drops[DropReason.JointTaken], Is.EqualTo(1), "the refusal is reported once");
        Assert.That(gateway.WebSocketConnections.Open, Is.EqualTo(2), "the former connection is still open");
    }

    [Test]
    public async Task JointState_TooManyClocksOffered_IsRefused()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        using var other = await RawRosbridgeClient.ConnectAsync(gateway);
        for (var i = 0; i <= PlantClocks.AtMost; i++)
        {
            await (i < PlantClocks.AtMost ? other : client).SendAsync(
                $$"""{"op":"advertise_service","service":"/nowpose/plant_time/clock{{i}}","type":"nowpose/PlantTime"}""");
            if (i < PlantClocks.AtMost) await Soon.BecomesAsync(() => gateway.PlantClocks.All.Count == i + 1, "it is offered");
        }

        await client.ExpectErrorAsync("OutOfRange");
        await client.SendAsync(Gateways.StateText(0.5));

        await client.ExpectErrorAsync("Unsynchronised");
    }

    [Test]
    public async Task AdvertiseService_ByAnObserver_IsRefused()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });
        using var observer = await RawRosbridgeClient.ConnectAsync(
            gateway, options => options.SetRequestHeader("Authorization", "Bearer " + Gateways.ObserverToken));

        await observer.SendAsync("""{"op":"advertise_service","service":"/nowpose/plant_time/plc","type":"nowpose/PlantTime"}""");

        await observer.ExpectErrorAsync("role");
        Assert.That(gateway.PlantClocks.All, Is.Empty);
    }

    // Connects an adapter and waits until the gateway is synchronised with the adapter's clock.
    static async Task<PlantAdapterDouble> ConnectedAsync(GatewayServer gateway, string name, StopwatchControlClock clock)
    {
        var adapter = await PlantAdapterDouble.ConnectAsync(gateway, name, clock);
        await Soon.BecomesAsync(() => StatusOf(gateway, name)?.State == ClockState.Synchronised, $"the clock '{name}' is known");
        return adapter;
    }

    static Task RequestedFiveTimesAsync(PlantAdapterDouble adapter)
    {
        var before = adapter.Requests;
        return Soon.BecomesAsync(() => adapter.Requests >= before + 5, "it is asked");
    }

    static PlantClockStatus StatusOf(GatewayServer gateway, string name) => gateway.Clock.Status().FirstOrDefault(clock => clock.Name == name);
}
