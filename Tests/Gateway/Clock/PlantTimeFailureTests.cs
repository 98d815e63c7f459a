using System.Collections.Concurrent;
using System.Diagnostics;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;

namespace Nowpose.Headless.Tests.Gateway.Clock;

/// <summary>Tests the requests of the gateway, over real sockets, if an adapter cannot read the clock of its control system.</summary>
public class PlantTimeFailureTests
{
    [Test]
    public async Task PlantTime_CallFails_IsCountedWithItsReason()
    {
        await using var gateway = await Gateways.StartAsync();
        using var adapter = await PlantAdapterDouble.ConnectAsync(gateway, "plc", (id, service) =>
            $$"""{"op":"service_response","id":"{{id}}","service":"{{service}}","result":false,"values":"the PLC is in stop"}""");

        await Soon.BecomesAsync(() => Status(gateway)?.Failures > 0, "the failure is counted");

        Assert.That(Status(gateway).LastFailure, Is.EqualTo("the PLC is in stop"));
        Assert.That(gateway.Clock.IsSynchronised, Is.False);
    }

    [Test]
    public async Task PlantTime_CallFails_IsRequestedAgainAfterASecond()
    {
        var asked = new ConcurrentQueue<TimeSpan>();
        var since = Stopwatch.StartNew();
        await using var gateway = await Gateways.StartAsync();
        using var adapter = await PlantAdapterDouble.ConnectAsync(gateway, "plc", (id, service) =>
        {
            asked.Enqueue(since.Elapsed);
            return $$"""{"op":"service_response","id":"{{id}}","service":"{{service}}","result":false,"values":"the PLC is in stop"}""";
        });

        await Soon.BecomesAsync(() => asked.Count == 3, "the clock is requested three times");

        // A timer may end some milliseconds early, and the first request may be read late.
        var times = asked.ToArray();
        Assert.That(times[2] - times[0], Is.GreaterThan(TimeSpan.FromSeconds(1)));
    }

    [Test]
    public async Task PlantTime_CallFailsWithALongText_IsShortenedToOneLine()
    {
        var reason = "stop\\n\\u0007" + new string('x', 5000);
        await using var gateway = await Gateways.StartAsync();
        using var adapter = await PlantAdapterDouble.ConnectAsync(gateway, "plc", (id, service) =>
            $$"""{"op":"service_response","id":"{{id}}","service":"{{service}}","result":false,"values":"{{reason}}"}""");

        await Soon.BecomesAsync(() => Status(gateway)?.Failures > 0, "the failure is counted");

        var kept = Status(gateway).LastFailure;
        Assert.That(kept, Does.StartWith("stop  xxx").And.Length.LessThanOrEqualTo(PlantClock.MaxFailureLength));
    }

    static PlantClockStatus Status(GatewayServer gateway) => gateway.Clock.Status().FirstOrDefault(clock => clock.Name == "plc");
}
