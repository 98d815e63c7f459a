using System.Diagnostics;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Headless.Tests.Gateway.Clock;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Cell.CellTexts;

namespace Nowpose.Headless.Tests.Gateway.Cell;

/// <summary>Tests frames and signals whose time stamps are on a plant clock other than the control clock C1.</summary>
public class CellPlantTimeTests
{
    [Test]
    public async Task Publish_TimeStampsOfAnotherPlantClock_AreConvertedToControlTime()
    {
        var own = new StopwatchControlClock(Gateways.Start);
        var plc = new StopwatchControlClock(Gateways.Start + TimeSpan.FromSeconds(900));
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { ControlClock = PlantClocks.Own }, own);
        using var adapter = await PlantAdapterDouble.ConnectAsync(gateway, "plc", plc);
        await Soon.BecomesAsync(
            () => gateway.Clock.Status().FirstOrDefault(clock => clock.Name == "plc")?.State == ClockState.Synchronised, "the plant's clock is known");
        using var headset = await RawRosbridgeClient.ConnectAsync(gateway);
        foreach (var topic in new[] { RosTopics.Tf, RosTopics.TfStatic, RosTopics.Signals }) await headset.SubscribeAsync(topic);

        var count = Stopwatch.GetTimestamp();
        var stamp = plc.AtCount(count);
        await adapter.Client.SendAsync(Tf(Frame("a", stamp: stamp), Frame("b", stamp: stamp)));
        await adapter.Client.SendAsync(TfStatic(Frame("c", stamp: default(ControlTime)), Frame("d", stamp: stamp)));
        await adapter.Client.SendAsync(SignalsAt(stamp, ("grip", 1)));

        var stamps = new Dictionary<string, ControlTime>();
        while (stamps.Count < 5)
        {
            var message = await headset.ReceiveAsync();
            for (var i = 0; i < (message.Transforms?.Count ?? 0); i++) stamps[message.Transforms[i].Child] = message.Transforms[i].Stamp;
            if (message.Signals != null) stamps["grip"] = message.Signals.Stamp;
        }

        Assert.That(stamps["c"], Is.EqualTo(default(ControlTime)), "a zero stamp stays");
        foreach (var name in new[] { "a", "b", "d", "grip" })
            Assert.That((stamps[name] - own.AtCount(count)).Duration(), Is.LessThan(TimeSpan.FromSeconds(1)), name);
    }
}
