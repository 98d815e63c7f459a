using System.Net;
using System.Net.Sockets;

namespace Nowpose.Gateway;

/// <summary>Listens on the gateway's ports; what keeps it from that is told of the option that is to blame.</summary>
static class PortListener
{
    /// <param name="option">Of the port.</param>
    /// <exception cref="IOException">The port cannot be had: it is taken, or the address is not this machine's. Either may pass.</exception>
    public static TcpListener Open(string option, IPAddress bind, int port)
    {
        TcpListener listener = null;
        try
        {
            listener = new TcpListener(bind, port);
            if (bind.Equals(IPAddress.IPv6Any)) listener.Server.DualMode = true;
            // On Unix .NET sets SO_REUSEADDR by itself when binding, so a restart need not wait for old connections to time out;
            // set here it would also let two gateways share the port.
            listener.Start();
            return listener;
        }
        catch (SocketException e)
        {
            listener?.Dispose();
            throw Refusal(option, bind, port, e);
        }
    }

    /// <summary>What is said of a port that the system refuses.</summary>
    public static IOException Refusal(string option, IPAddress bind, int port, Exception cause) => IsOfThePort(cause)
        ? new IOException($"{option} {port} on {bind}: {cause.Message}", cause)
        : new IOException($"--bind {bind}: is no address of this machine now ({cause.Message})", cause);

    /// <summary>Whether somebody else listens there at the moment.</summary>
    public static bool IsTaken(IOException refusal) =>
        refusal.InnerException is SocketException { SocketErrorCode: SocketError.AddressAlreadyInUse };

    static bool IsOfThePort(Exception cause) =>
        cause is not SocketException refused || refused.SocketErrorCode is SocketError.AddressAlreadyInUse or SocketError.AccessDenied;
}
