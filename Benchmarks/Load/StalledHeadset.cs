using System.Net;
using System.Net.Sockets;
using Nowpose.Protocol;

namespace Nowpose.Benchmarks.Load;

/// <summary>A headset that asks for much and reads nothing; the gateway ends it when no pong comes, and it comes again.</summary>
static class StalledHeadset
{
    const int LittleBytes = 4096;
    const int Descriptions = 200;
    static readonly TimeSpan Patience = TimeSpan.FromSeconds(9);
    static readonly TimeSpan Pause = TimeSpan.FromSeconds(1);

    public static async Task RunAsync(GatewayUnderLoad gateway, CancellationToken stop)
    {
        try
        {
            while (true)
            {
                if (await ProblemAsync(gateway.WebSocket, stop) is not { } problem) continue;
                // While the results are said to be with it.
                Console.Error.WriteLine($"the headset that reads nothing: {problem}; it comes again");
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
            // The gateway is ended first.
            stop.ThrowIfCancellationRequested();
            return end.Message;
        }
    }

    static async Task StallAsync(IPEndPoint server, CancellationToken stop)
    {
        using var socket = await LeanSocket.OpenAsync(server, LittleBytes);
        await LeanSocket.SendTextAsync(socket, RosbridgeWriter.Subscribe(RosTopics.JointStates));
        // Each of these is answered with the whole robot: what is waiting soon exceeds every buffer.
        for (var i = 0; i < Descriptions; i++)
            await LeanSocket.SendTextAsync(socket, RosbridgeWriter.Subscribe(RosTopics.RobotDescription));
        await Task.Delay(Patience, stop);
    }
}
