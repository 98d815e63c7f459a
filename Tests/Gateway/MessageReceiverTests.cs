using System.Text;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Gateway.Sync;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

public class MessageReceiverTests
{
    [TestCase(4.9, DropReason.None)]
    [TestCase(5.1, DropReason.TooSlow)]
    public async Task Message_CompletedBeforeOrAfterTheTimeout_IsDroppedOnlyIfLateAndTheNextIsAccepted(double seconds, object expected)
    {
        var time = new ManualTime();
        using var socket = new ScriptedWebSocket(
            ("a ", false, () => { }
        ), ("mess", false, () => { }
        ), ("age", true, () => time.Advance(seconds)),
            ("the ", false, () => time.Advance(60)), ("next", true, () => time.Advance(4.9)));
        var receiver = new MessageReceiver(
            socket, new FragmentCounter(), new GatewayOptions(), ProtocolLimits.MessageBytes, new RequestRate(100), time);

        var late = Content(await receiver.NextAsync());
        var next = Content(await receiver.NextAsync());

        Assert.That(late, Is.EqualTo(((DropReason)expected == DropReason.None ? "a message" : "", (DropReason)expected, (Closure?)null, Count(seconds))));
        Assert.That(next, Is.EqualTo(("the next", DropReason.None, (Closure?)null, Count(seconds + 60 + 4.9))));
    }

    // Copies the text, because the next message is written to the same memory.
    static (string Text, DropReason Fault, Closure? End, long Count) Content(in Received received) =>
        (Encoding.UTF8.GetString(received.Utf8.Span), received.Fault, received.End, received.Count);

    static long Count(double seconds) => TimeSpan.FromSeconds(seconds).Ticks;

    sealed class ManualTime : TimeProvider
    {
        long _ticks;

        public override long TimestampFrequency => TimeSpan.TicksPerSecond;
        public override long GetTimestamp() => _ticks;
        public void Advance(double seconds) => _ticks += TimeSpan.FromSeconds(seconds).Ticks;
    }
}
