using System.Threading.Channels;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Cell;

/// <summary>Tests the order in which a slow subscriber to a latched topic receives the names.</summary>
[FixtureLifeCycle(LifeCycle.InstancePerTestCase)]
public class LatchedQueueOrderTests
{
    readonly MessageHub _hub = new();

    [TestCase(false)]
    [TestCase(true)]
    public void Next_SignalsChangeFasterThanASlowClientReads_ReturnsAllSignalsInTurn(bool isThrottled)
    {
        using var source = _hub.OpenSource();
        using var subscription = Subscribe(isThrottled, out var queue);
        var returned = new List<string>();

        for (var i = 0; i < 12; i++)
        {
            foreach (var name in new[] { "a", "b", "c" }) source.Publish(new SignalsMessage(Gateways.Start, new SignalValue(name, i)), []);
            returned.Add(((SignalsMessage)queue.Next(_ => true).Content)[0].Name);
        }

        Assert.That(string.Concat(returned), Is.EqualTo("abcabcabcabc"));
    }

    [Test]
    public void Next_SlowClientAndSignalsPublishedTogether_ReturnsNoOlderValueOfASignal()
    {
        using var source = _hub.OpenSource();
        using var subscription = Subscribe(isThrottled: false, out var queue);
        var random = new Random(5);
        var newest = new Dictionary<string, double>();

        for (var i = 0; i < 500; i++)
        {
            var values = new[] { "a", "b", "c" }.Where(_ => random.Next(2) == 0).Select(name => new SignalValue(name, i)).ToArray();
            if (values.Length > 0) source.Publish(new SignalsMessage(Gateways.Start, values), []);
            if (queue.Next(_ => random.Next(2) == 0)?.Content is not SignalsMessage message) continue;
            for (var k = 0; k < message.Count; k++)
            {
                Assert.That(message[k].Value, Is.GreaterThanOrEqualTo(newest.GetValueOrDefault(message[k].Name, -1)), $"seed 5, step {i}, {message[k].Name}");
                newest[message[k].Name] = message[k].Value;
            }
        }

        Assert.That(newest.Keys, Is.EquivalentTo(new[] { "a", "b", "c" }));
    }

    IDisposable Subscribe(bool isThrottled, out LatchedQueue queue)
    {
        var queued = Channel.CreateUnbounded<HubMessage>();
        queue = new LatchedQueue(_hub, RosTopics.Signals, queued, isThrottled, () => { });
        queue.Start();
        return _hub.SubscribeToNew(RosTopics.Signals, message => queued.Writer.TryWrite(message));
    }
}
