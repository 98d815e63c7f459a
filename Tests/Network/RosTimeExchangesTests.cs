using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Sync;
using Nowpose.Sync.Ransac;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Network;

public class RosTimeExchangesTests
{
    [Test]
    public async Task Run_NewConnection_DoesNotKeepTheStatusOfTheEarlierOne()
    {
        var clock = new SteppedClock();
        var exchanges = new RosTimeExchanges(
            clock, new ClockSynchroniser(new RansacClockEstimator(RansacSettings.Paper), ClockSettings.Default), new SyncFaultCounters(),
            new ExchangePace(TimeSpan.FromMilliseconds(200), TimeSpan.FromSeconds(5), new Random(1)));
        await RunAsync(exchanges, clock, sent => exchanges.Answered(Refusal(sent), DropReason.None, clock.Now), LinkState.Waiting);

        await RunAsync(exchanges, clock, _ => { }, LinkState.Connecting);
    }

    static async Task RunAsync(RosTimeExchanges exchanges, IHeadsetClock clock, Action<RosbridgeMessage> send, LinkState expected)
    {
        using var link = new CallLink(send);
        using var sender = new LinkSender(link, clock);
        using var end = new CancellationTokenSource();

        var running = exchanges.RunAsync(sender, end.Token);
        await link.Called.Bounded();
        await Soon.BecomesAsync(() => exchanges.Status.State == expected, expected.ToString());

        await end.CancelAsync();
        Assert.That(async () => await running.Bounded(), Throws.InstanceOf<OperationCanceledException>());
    }

    static RosbridgeMessage Refusal(RosbridgeMessage call)
    {
        RosbridgeReader.TryRead(
            $$"""{"op":"service_response","id":"{{call.Id}}","service":"/rosapi/get_time","values":"no rosapi","result":false}""", out var response, out _);
        return response;
    }

    sealed class CallLink(Action<RosbridgeMessage> send) : IWebSocketLink
    {
        readonly TaskCompletionSource _called = new(TaskCreationOptions.RunContinuationsAsynchronously);

        public Task Called => _called.Task;

        public Task OpenAsync(CancellationToken cancel) => Task.CompletedTask;

        public Task SendAsync(string text, CancellationToken cancel)
        {
            RosbridgeReader.TryRead(text, out var message, out _);
            send(message);
            _called.TrySetResult();
            return Task.CompletedTask;
        }

        public Task<string> ReceiveAsync(Action<ReceivedText> take, CancellationToken cancel) => throw new NotSupportedException();
        public void Dispose() { }
    }
}
