using System.Text;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Fuzz;

/// <summary>Passes malformed messages to the gateway's session without a socket, so that a failure shows the message that caused it.</summary>
public class SessionFuzzTests
{
    const int Seed = 12, Messages = 30_000;

    [Test]
    public void Handle_DamagedMessages_DoesNotThrow()
    {
        var hub = new MessageHub();
        var plant = new PlantClocks(null, new StopwatchHeadsetClock());
        var clock = new ServedClock(new StopwatchControlClock(ControlTime.FromSeconds(1_700_000_001)), plant);
        var (drops, replies) = (new DropCounters(), 0);
        using var session = new RosbridgeSession(
            hub, clock, plant, new NamesInUse(TimeProvider.System), Role.Source, drops, 16, _ => replies++, subscription => subscription.Dispose());
        var (random, mutator) = (new Random(Seed), new TextMutator(Seeds.Messages));

        for (var i = 0; i < Messages; i++)
        {
            var text = mutator.Next(random);
            Assert.DoesNotThrow(() => session.Handle(new Received(Encoding.UTF8.GetBytes(text), DropReason.None, null)), $"seed {Seed}: {text}");
        }

        Assert.That(drops.Total, Is.InRange(Messages / 20, Messages));
        Assert.That(replies, Is.GreaterThan(0));
    }
}
