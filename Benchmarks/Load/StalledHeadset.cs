using System.Net;
using System.Net.Sockets;
using Nowpose.Protocol;

namespace Nowpose.Benchmarks.Load;

/// <summary>A headset that requests much data and reads nothing. The gateway closes it when no pong arrives, and it reconnects.</summary>
static class StalledHeadset
{
    const int LittleBytes = 4096;
    const int Descriptions = 200;
    static readonly TimeSpan StallTime = TimeSpan.FromSeconds(9);
    static readonly TimeSpan Pause = TimeSpan.FromSeconds(1);

    public static async Task RunAsync(GatewayUnderLoad gateway, CancellationToken stop)
    {
        try
        {
            while (true)
            {
                if (await ProblemAsync(gateway.WebSocket, stop) is not { } problem) continue;
                // Logged, because the results must be measured with this headset connected.
                Console.Error.WriteLine($"the headset that stops reading: {problem}; it reconnects");
                await Task.Delay(Pause, stop);
            }
        }
        catch (OperationCanceledException)
        {
            // Stopped.
        }
    }

    static async Task<string> ProblemAsync(IPEndPoint server, CancellationToken stop)
    {
        try
        {
            await StallAsync(server, stop);
            return null;
        }
        catch (Exception end) when (end is SocketException or IOException)
        {
            // The gateway has ended first.
            stop.ThrowIfCancellationRequested();
            return end.Message;
        }
    }

    static async Task StallAsync(IPEndPoint server, CancellationToken stop)
    {
        using var socket = await LeanSocket.OpenAsync(server, LittleBytes);
        await LeanSocket.SendTextAsync(socket, RosbridgeWriter.Subscribe(RosTopics.JointStates));
        // Each of these is answered with the whole robot description, which soon exceeds every buffer.
        for (var i = 0; i < Descriptions; i++)
            await LeanSocket.SendTextAsync(socket, RosbridgeWriter.Subscribe(RosTopics.RobotDescription));
        await Task.Delay(StallTime, stop);
    }
}
