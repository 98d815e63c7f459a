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
    public async Task Message_LateInEnding_IsDroppedAndTheNextTaken(double seconds, DropReason expected)
    {
        var time = new ManualTime();
        using var socket = new ScriptedWebSocket(
            ("a ", false, () => { }), ("mess", false, () => { }), ("age", true, () => time.Advance(seconds)),
            ("the ", false, () => time.Advance(60)), ("next", true, () => time.Advance(4.9)));
        var receiver = new MessageReceiver(
            socket, new FragmentCounter(), new GatewayOptions(), ProtocolLimits.MessageBytes, new RequestRate(100), time);

        var late = await receiver.NextAsync();
        var next = await receiver.NextAsync();

        Assert.That(late, Is.EqualTo(new Received(expected == DropReason.None ? "a message" : null, expected, null, Count(seconds))));
        Assert.That(next, Is.EqualTo(new Received("the next", DropReason.None, null, Count(seconds + 60 + 4.9))));
    }

    static long Count(double seconds) => TimeSpan.FromSeconds(seconds).Ticks;

    sealed class ManualTime : TimeProvider
    {
        long _ticks;

        public override long TimestampFrequency => TimeSpan.TicksPerSecond;
        public override long GetTimestamp() => _ticks;
        public void Advance(double seconds) => _ticks += TimeSpan.FromSeconds(seconds).Ticks;
    }
}
