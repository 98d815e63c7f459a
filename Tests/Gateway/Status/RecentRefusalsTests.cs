using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Status.Events;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class RecentRefusalsTests
{
    // A source may repeat its refusal 1000 times per second, under the hub's lock.
    [TestCase(0.5, 0)]
    [TestCase(1.5, 1)]
    public void Add_TheSameRefusalAgain_CountsOnlyAfterASecond(double againAfterSeconds, int expected)
    {
        var (time, hub) = (new SteppedTime(), new MessageHub());
        using var source = hub.OpenSource();
        using var owner = hub.OpenSource();
        var refusals = new RecentRefusals(time);
        refusals.Add(source, RosTopics.JointStates, "a", owner);
        time.Advance(TimeSpan.FromSeconds(againAfterSeconds));
        refusals.Add(source, RosTopics.JointStates, "a", owner);

        time.Advance(TimeSpan.FromSeconds(5.2 - againAfterSeconds));

        Assert.That(refusals.Read(), Has.Count.EqualTo(expected));
    }
}
