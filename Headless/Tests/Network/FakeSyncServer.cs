using System.Net;
using System.Net.Sockets;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Network;

/// <summary>A sync server on loopback that answers as a test wants, one connection after another.</summary>
sealed class FakeSyncServer : IDisposable
{
    readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    readonly Func<SyncFrame, byte[]> _answer;
    int _connections;

    /// <param name="answer">The bytes to send back for a request; null closes the connection.</param>
    public FakeSyncServer(Func<SyncFrame, byte[]> answer)
    {
        _answer = answer;
        _listener.Start();
        new Thread(Serve) { IsBackground = true }.Start();
    }

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

    /// <summary>Connections accepted so far.</summary>
    public int Connections => Volatile.Read(ref _connections);

    public static byte[] Bytes(SyncFrame frame)
    {
        var bytes = new byte[SyncFrame.Size];
        frame.Write(bytes);
        return bytes;
    }

    public void Dispose() => _listener.Stop();

    void Serve()
    {
        try
        {
            while (true)
            {
                using var client = _listener.AcceptTcpClient();
                Interlocked.Increment(ref _connections);
                try
                {
                    ServeOne(client.GetStream());
                }
                catch (IOException)
                {
                    // The client went away; the next one may come.
                }
            }
        }
        catch (Exception end) when (end is SocketException or InvalidOperationException)
        {
            // Stopped.
        }
    }

    void ServeOne(NetworkStream stream)
    {
        var request = new byte[SyncFrame.Size];
        while (true)
        {
            stream.ReadExactly(request);
            SyncFrame.TryRead(request, out var frame, out _);
            var answer = _answer(frame);
            if (answer == null) return;
            stream.Write(answer);
        }
    }
}
