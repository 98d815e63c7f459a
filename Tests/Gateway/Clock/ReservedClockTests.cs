using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Clock;

/// <summary>Tests of the clocks of the plants whose adapters the gateway starts itself.</summary>
public class ReservedClockTests
{
    static readonly GatewayOptions Options = Gateways.Options() with { Tokens = Gateways.Tokens, ReservedClocks = ["press"] };
    static readonly ControlTime PlantStart = ControlTime.FromSeconds(900_000);

    [Test]
    public async Task ReservedClock_OfferedByASourceFirst_IsServedByTheAdapterOfTheGateway()
    {
        await using var gateway = await Gateways.StartAsync(Options);
        using var other = await PlantAdapterDouble.ConnectAsync(
            gateway, "press", new StopwatchControlClock(PlantStart + TimeSpan.FromHours(1)), token: Gateways.SourceToken);
        await Soon.BecomesAsync(() => other.Requests > 5, "the clock of the source is measured");
        Assert.That(gateway.PlantClocks.Control?.IsConnected, Is.False, "the source serves the clock of the plant");

        using var adapter = await PlantAdapterDouble.ConnectAsync(gateway, "press", new StopwatchControlClock(PlantStart), token: gateway.AdapterToken);
        await Soon.BecomesAsync(() => gateway.Clock.State == ClockState.Synchronised, "the clock is served");

        Assert.That((gateway.Clock.Now - PlantStart).Duration(), Is.LessThan(TimeSpan.FromMinutes(30)));
    }

    [Test]
    public async Task ReservedClock_OfferedByASource_IsRefusedWithTheRemedy()
    {
        await using var gateway = await Gateways.StartAsync(Options);
        using var source = await RawRosbridgeClient.ConnectAsync(
            gateway, options => options.SetRequestHeader("Authorization", $"Bearer {Gateways.SourceToken}"));

        await source.SendAsync($$"""{"op":"advertise_service","service":"{{RosTopics.PlantTime}}press","type":"nowpose/PlantTime"}""");

        await source.ExpectErrorAsync(DropMessages.ReservedClock("press"));
    }

    [Test]
    public void Find_AllClocksOfferedByOthers_CreatesTheReservedClock()
    {
        var clocks = new PlantClocks(null, new SteppedClock(), ["press"]);
        List<PlantClockCaller> callers = [];
        for (var i = 0; i < PlantClocks.AtMost; i++)
        {
            var clock = clocks.Find($"plc-{i}");
            callers.Add(new PlantClockCaller(clock, clocks.Counter, TimeProvider.System, _ => { }));
            clock.TryAttach(callers[i]);
        }

        Assert.That(clocks.Find("press"), Is.Not.Null);
        callers.ForEach(caller => caller.Dispose());
    }
}
