using System.Net;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Messages;
using Nowpose.Headless.Tests.Gateway.Status.Faults;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Clock;

public class PlantClocksTests
{
    // The first clock that is offered is C1, unless another one is selected.
    [TestCase(null, "first")]
    [TestCase("selected", "selected")]
    [TestCase(PlantClocks.Own, null)]
    public void Find_MaximumNumberOfClocks_ReplacesAClockWithoutAnAdapterThatIsNotC1(string wanted, string control)
    {
        var clocks = new PlantClocks(wanted, new SteppedClock());
        clocks.Find("first");
        var offered = clocks.Find("offered");
        using var caller = new PlantClockCaller(offered, clocks.Counter, TimeProvider.System, _ => { });
        offered.TryAttach(caller);

        for (var i = 0; i < 3 * PlantClocks.AtMost; i++) Assert.That(clocks.Find($"other-{i}"), Is.Not.Null);

        Assert.That(clocks.All, Has.Count.EqualTo(PlantClocks.AtMost).And.Contains(offered));
        Assert.That(clocks.Control?.Name, Is.EqualTo(control));
    }

    [Test]
    public void Find_AllClocksOffered_ReturnsNull()
    {
        var clocks = new PlantClocks(null, new SteppedClock());
        List<PlantClockCaller> callers = [];
        for (var i = 0; i < PlantClocks.AtMost; i++)
        {
            var clock = clocks.Find($"plc-{i}");
            callers.Add(new PlantClockCaller(clock, clocks.Counter, TimeProvider.System, _ => { }));
            clock.TryAttach(callers[i]);
        }

        Assert.That(clocks.Find("one-more"), Is.Null);
        foreach (var caller in callers) caller.Dispose();
    }

    [Test]
    public async Task Readiness_SelectedClockNeverOffered_NamesTheOfferedClocks()
    {
        await using var gateway = new MonitoredGateway();
        await gateway.StartAsync(options => options with { ControlClock = "plc-opuca" });
        gateway.Server.PlantClocks.Find("plc-opcua");

        var lines = await gateway.ReadyAsync(HttpStatusCode.ServiceUnavailable);

        Assert.That(lines, Has.One.StartsWith($"{EventTexts.ClockNotServed(EventTexts.ControlClock("plc-opuca"))}: {EventTexts.ClockNotOffered(["plc-opcua"])}"));
        Assert.That(lines, Has.One.EndsWith(EventRemedies.ClockName));
    }
}
