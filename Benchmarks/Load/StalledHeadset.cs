using System.Net;
using System.Net.WebSockets;
using Nowpose.Protocol;

namespace Nowpose.Benchmarks.Load;

/// <summary>A headset that requests a lot of data and stops reading. When the gateway closes the connection, the headset reconnects.</summary>
static class StalledHeadset
{
    const int LittleBytes = 4096;
    const int Descriptions = 200;
    static readonly TimeSpan StallTime = TimeSpan.FromSeconds(9);
    static readonly TimeSpan Pause = TimeSpan.FromSeconds(1);

    public static async Task RunAsync(GatewayProcess gateway, CancellationToken stop)
    {
        try
        {
            while (true)
            {
                if (await ProblemAsync(gateway.WebSocket, stop) is not { } problem) continue;
                // Logs each disconnection, because the results are valid only with this headset connected.
                Console.Error.WriteLine($"the headset that stops reading: {problem}; it reconnects");
                await Task.Delay(Pause, stop);
            }
        }
        catch (OperationCanceledException)
        {
            // Expected: the measurement has ended.
        }
    }

    static async Task<string> ProblemAsync(IPEndPoint server, CancellationToken stop)
    {
        try
        {
            await StallAsync(server, stop);
            return null;
        }
        catch (Exception end) when (end is WebSocketException)
        {
            // The gateway closed the connection.
            stop.ThrowIfCancellationRequested();
            return end.Message;
        }
    }

    static async Task StallAsync(IPEndPoint server, CancellationToken stop)
    {
        using var socket = await LeanSocket.OpenAsync(server, LittleBytes);
        await LeanSocket.SendTextAsync(socket, RosbridgeWriter.Subscribe(RosTopics.JointStates));
        // The gateway responds to each of these messages with the complete robot description, which soon fills all buffers.
        for (var i = 0; i < Descriptions; i++)
            await LeanSocket.SendTextAsync(socket, RosbridgeWriter.Subscribe(RosTopics.RobotDescription));
        await Task.Delay(StallTime, stop);
    }
}
