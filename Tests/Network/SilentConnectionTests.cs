using Nowpose.Network;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Network;

/// <summary>Tests a connection that is silent while the gateway responds to the clock sync, as after a gap of the network.</summary>
public class SilentConnectionTests
{
    [TestCase(3.4, false)]
    [TestCase(3.6, true)]
    public async Task EndIfSilent_SilentForSomeSeconds_ReconnectsIfAWorkingConnectionIsNotSoLongSilent(double silentSeconds, bool isEnded)
    {
        using var server = new FakeWebSocketServer();
        var clock = new SteppedClock();
        clock.Set(10);
        var listener = new QueuedListener();
        var settings = new ConnectionSettings("127.0.0.1", webSocketPort: server.Port);
        using var client = new RosbridgeClient(
            () => WebSocketLinks.Create(settings, clock), clock, listener, Subscribed.ToRobot(), publishesDisplayed: false);
        using var first = await server.AcceptAsync();
        await PlayedServer.Send(first, PlayedServer.Good);
        await Soon.BecomesAsync(() => listener.Messages.Count == 1, "a message");
        clock.Set(10 + silentSeconds);

        Assert.That(client.EndIfSilent(), Is.EqualTo(isEnded));

        if (!isEnded) return;
        using var second = await server.AcceptAsync();
        await PlayedServer.Send(second, PlayedServer.Good);
        await Soon.BecomesAsync(() => listener.Messages.Count == 2, "a message over another connection");
    }
}
