using System.Net.Sockets;
using Microsoft.AspNetCore.Connections.Features;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Limits the unsent data in the kernel, for slow readers that do not answer pings.</summary>
static class SendBuffer
{
    const int UnsentBytes = 4096;
    const int BufferBytes = 16 * 1024;

    // Constants from <netinet/tcp.h>.
    const int ProtocolTcp = 6;
    const int LinuxNotSentLowWater = 25;
    const int MacNotSentLowWater = 0x201;

    public static void Limit(HttpContext context)
    {
        if (context.Features.Get<IConnectionSocketFeature>()?.Socket is not { } socket) return;
        try
        {
            // Limits only unsent data. A small buffer would also limit data in flight, and so the throughput of a long path.
            if (OperatingSystem.IsLinux()) socket.SetRawSocketOption(ProtocolTcp, LinuxNotSentLowWater, BitConverter.GetBytes(UnsentBytes));
            else if (OperatingSystem.IsMacOS()) socket.SetRawSocketOption(ProtocolTcp, MacNotSentLowWater, BitConverter.GetBytes(UnsentBytes));
            else socket.SendBufferSize = BufferBytes;
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            // The connection has ended. The receiving loop detects this.
        }
    }
}
