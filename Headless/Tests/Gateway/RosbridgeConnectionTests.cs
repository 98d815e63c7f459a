using System.Net.WebSockets;
using NUnit.Framework;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

public class RosbridgeConnectionTests
{
    [Test]
    public async Task Start_AfterSubscriptionsThatEnded_ForgetsThem()
    {
        using var socket = WebSocket.CreateFromStream(new MemoryStream(), new WebSocketCreationOptions { IsServer = true });
        using var connection = new RosbridgeConnection(socket, null, CancellationToken.None);
        var hub = new MessageHub();

        void StartAndEnd()
        {
            using var subscription = new Subscription(hub, RosTopics.JointStates, default, 16, new DropCounters());
            connection.Start(subscription);
        }

        for (var i = 0; i < 100; i++)
            StartAndEnd();
        await Soon.BecomesAsync(() => { StartAndEnd(); return connection.Pumps < 10; }, "forgotten");
    }
}
