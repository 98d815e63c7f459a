using System.Collections.Concurrent;
using System.Text;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Clock;

/// <summary>Tests, in virtual time, what a source receives whose clock is not the control clock and does not run in real time.</summary>
public class ClockRateRefusalTests
{
    [Test]
    public void Sample_OfASecondClockAtHalfSpeed_IsRefusedWithTheClockItsRateAndTheRemedy()
    {
        var counter = new SteppedClock();
        var plant = new PlantClocks(PlantClocks.Own, counter);
        var replies = new ConcurrentQueue<string>();
        using var session = new RosbridgeSession(
            new MessageHub(), new ServedClock(new StopwatchControlClock(Gateways.Start), plant), plant, new NamesInUse(TimeProvider.System), Role.Source,
            new DropCounters(), 16, reply => replies.Enqueue(Encoding.UTF8.GetString(reply.Span)), _ => { });
        void Handle(string text) => session.Handle(new Received(Encoding.UTF8.GetBytes(text), DropReason.None, null));
        Handle($$"""{"op":"advertise_service","service":"{{RosTopics.PlantTime}}scaled","type":"nowpose/PlantTime"}""");

        var delay = TimeSpan.FromMilliseconds(0.2);
        for (var i = 1; i <= 70; i++)
        {
            var (now, time) = (HeadsetTime.FromSeconds(0.1 * i), ControlTime.FromSeconds(900_000 + 0.05 * i));
            counter.Set(0.1 * i);
            plant.Find("scaled").Add(new SyncExchange(now - delay, time, time, now + delay, TimeSpan.FromMicroseconds(1)));
        }

        Handle(Gateways.StateText(0.5));
        Handle(RosbridgeWriter.Publish(RosTopics.Signals, new SignalsMessage(Gateways.Start, new SignalValue("s", 1)), RosTimeForm.Sec));

        var rule = DropMessages.ClockRate(EventTexts.ClockAtWrongRate("scaled", 0.5));
        Assert.That(replies.Count(reply => reply.Contains($"{rule} ({nameof(DropReason.Unsynchronised)})", StringComparison.Ordinal)), Is.EqualTo(2));
    }
}
