using System.Net.Sockets;
using Nowpose.Protocol;

namespace Nowpose.Tests.Common;

/// <summary>A sync server whose responses a test defines.</summary>
sealed class FakeSyncServer : IDisposable
{
    readonly FakeTcpServer _server;

    /// <param name="answer">Returns the bytes to send back for a request; null closes the connection.</param>
    public FakeSyncServer(Func<SyncFrame, byte[]> answer) => _server = new FakeTcpServer(stream => Serve(stream, answer));

    public int Port => _server.Port;
    public int Connections => _server.Connections;

    public static byte[] Bytes(SyncFrame frame)
    {
        var bytes = new byte[SyncFrame.Size];
        frame.Write(bytes);
        return bytes;
    }

    public void Dispose() => _server.Dispose();

    static void Serve(NetworkStream stream, Func<SyncFrame, byte[]> answer)
    {
        var request = new byte[SyncFrame.Size];
        while (true)
        {
            stream.ReadExactly(request);
            SyncFrame.TryRead(request, out var frame, out _);
            var bytes = answer(frame);
            if (bytes == null) return;
            stream.Write(bytes);
        }
    }
}
