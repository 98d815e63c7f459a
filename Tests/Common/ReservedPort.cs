using System.Net;
using System.Net.Sockets;

namespace Nowpose.Tests.Common;

/// <summary>
/// A free port for a program that ends and starts again on the same port. The reservation is a listener on another port: two tests that find the same
/// port while no program listens on it would use the same program. All ports are below 32768, where the system assigns ports to connections.
/// </summary>
sealed class ReservedPort : IDisposable
{
    const int First = 14_000, Ports = 2000;

    readonly TcpListener _reservation;

    public ReservedPort()
    {
        do
        {
            _reservation?.Stop();
            Port = First + Random.Shared.Next(Ports);
            _reservation = Listening(Port + Ports);
        }
        while (_reservation == null || !IsFree(Port));
    }

    public int Port { get; }

    public void Dispose() => _reservation.Stop();

    static bool IsFree(int port)
    {
        var trial = Listening(port);
        trial?.Stop();
        return trial != null;
    }

    /// <summary>Returns a listener on a port; null if the port is taken.</summary>
    static TcpListener Listening(int port)
    {
        var listener = new TcpListener(IPAddress.Loopback, port);
        try
        {
            listener.Start();
            return listener;
        }
        catch (SocketException)
        {
            return null;
        }
    }
}
