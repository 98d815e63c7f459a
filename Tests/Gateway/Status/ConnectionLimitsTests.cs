using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Status.Events;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class ConnectionLimitsTests
{
    // The system may have run for longer or shorter than the time for which the maximum counts as reached.
    [TestCase(0)]
    [TestCase(60)]
    public void Read_ConnectionsAlternateAtTheMaximum_CountsAsReachedUntilFiveSecondsAfterTheLastOne(double uptimeSeconds)
    {
        const int Max = 2;
        var (time, counters) = (new SteppedTime(), new ConnectionCounters());
        time.Advance(TimeSpan.FromSeconds(uptimeSeconds));
        var limits = new ConnectionLimits([("websocket", counters)], Max, time);
        counters.TryEnter(Max);
        Assert.That(limits.Read(), Is.Empty);

        for (var i = 0; i < 3; i++)
        {
            counters.TryEnter(Max);
            Assert.That(limits.Read(), Has.Count.EqualTo(1));
            counters.Leave(Closure.ByPeer);
            time.Advance(TimeSpan.FromSeconds(4));
            Assert.That(limits.Read(), Has.Count.EqualTo(1));
        }

        time.Advance(TimeSpan.FromSeconds(2));
        Assert.That(limits.Read(), Is.Empty);
    }

    [Test]
    public void Read_ConnectionsOfASourceRefused_IsAConditionUntilFiveSecondsAfterTheLastOne()
    {
        var (time, counters) = (new SteppedTime(), new ConnectionCounters());
        var limits = new ConnectionLimits([("websocket", counters)], 2, time);
        counters.Count(Closure.SourceLimit);

        Assert.That(limits.Read().Single().Text, Does.Contain(EventTexts.RefusedOfSources(1)));
        time.Advance(TimeSpan.FromSeconds(6));
        Assert.That(limits.Read(), Is.Empty);
    }

    [Test]
    public void Read_ConnectionsRefusedForDescriptors_IsAConditionUntilFiveSecondsAfterTheLastOne()
    {
        var (time, counters) = (new SteppedTime(), new ConnectionCounters());
        var limits = new ConnectionLimits([("sync", new ConnectionCounters()), ("websocket", counters)], 2, time);
        for (var i = 1; i <= 3; i++)
        {
            counters.Count(Closure.DescriptorLimit);

            Assert.That(limits.Read().Single().Text, Does.StartWith(EventTexts.PortWithoutDescriptor("websocket")).And.Contains(EventTexts.RefusedForDescriptors(i)));
            time.Advance(TimeSpan.FromSeconds(4));
        }

        time.Advance(TimeSpan.FromSeconds(2));
        Assert.That(limits.Read(), Is.Empty);
    }
}
