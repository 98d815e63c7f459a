using NUnit.Framework;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

public class SubscriptionTests
{
    [Test]
    public async Task Dispose_WhileItWaitsOutALongThrottle_EndsThePump()
    {
        var hub = new MessageHub();
        using var source = hub.OpenSource();
        var subscription = new Subscription(
            hub, RosTopics.JointStates, new SubscriptionTerms(RosTimeForm.Sec, int.MaxValue, 0), 16, new DropCounters());
        var sent = new TaskCompletionSource();
        var pump = subscription.PumpAsync(
            _ =>
            {
                sent.TrySetResult();
                return Task.CompletedTask;
            },
            CancellationToken.None);
        source.TryPublish(new JointStateMessage(ControlTime.FromSeconds(1), ["a"], [0.5]));
        await sent.Task.Bounded();

        subscription.Dispose();

        await pump.Bounded();
    }
}
