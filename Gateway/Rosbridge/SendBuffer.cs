using System.Net.Sockets;
using Microsoft.AspNetCore.Connections.Features;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Limits the kernel's unsent data for a slow reader that does not answer pings.</summary>
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
            // Unlike a small buffer, this limits only unsent data, so it does not reduce the throughput of a long path.
            if (OperatingSystem.IsLinux()) socket.SetRawSocketOption(ProtocolTcp, LinuxNotSentLowWater, BitConverter.GetBytes(UnsentBytes));
            else if (OperatingSystem.IsMacOS()) socket.SetRawSocketOption(ProtocolTcp, MacNotSentLowWater, BitConverter.GetBytes(UnsentBytes));
            else socket.SendBufferSize = BufferBytes;
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            // The connection has ended, which the receiving side detects.
        }
    }
}
