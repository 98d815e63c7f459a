using System.Diagnostics;
using Nowpose.Gateway;
using Nowpose.Gateway.Plants;
using Nowpose.Headless.Tests.Gateway;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Session;

/// <summary>Tests that a session leaves no resources behind. Each pause of the application ends a session.</summary>
[NonParallelizable] // measures the memory of the whole process
public class SessionLeakTests
{
    readonly StopwatchHeadsetClock _clock = new();

    [Test]
    public async Task Sessions_ConnectedAndDisposed_LeaveNoThreadsOrConnections()
    {
        await using var gateway = await Gateways.StartAsync();
        await CycleAsync(gateway, 10);
        var before = ProcessCounts.Threads();

        await CycleAsync(gateway, 50);

        Assert.That(ProcessCounts.Threads(), Is.LessThan(before + 10), "the thread pool may grow, but not by one thread per session");
    }

    async Task CycleAsync(GatewayServer gateway, int count)
    {
        var connection = new ConnectionSettings("127.0.0.1", gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port);
        var settings = new SessionSettings(connection, VisualisationLatency.FromMilliseconds(40));
        for (var i = 0; i < count; i++)
        {
            using var session = new CompensationSession(settings, RobotFiles.Load("youbot"), _clock);
            session.Connect();
            // Every second session is ended before it has connected.
            if (i % 2 == 0)
                await Soon.BecomesAsync(() => session.Statistics(_clock.Now).SyncLink.State == LinkState.Connected, "connected");
        }
        await Soon.BecomesAsync(() => gateway.SyncConnections.Open == 0 && gateway.WebSocketConnections.Open == 0, "no connection at the gateway");
    }
}
