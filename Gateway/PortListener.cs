using System.Net;
using System.Net.Sockets;
using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway;

/// <summary>Listens on the gateway's ports. Errors name the responsible option.</summary>
static class PortListener
{
    /// <param name="option">Name of the port's option.</param>
    /// <exception cref="IOException">The port is in use, or the address does not belong to this machine. Both may be temporary.</exception>
    public static TcpListener Open(string option, IPAddress bind, int port)
    {
        TcpListener listener = null;
        try
        {
            listener = new TcpListener(bind, port);
            if (bind.Equals(IPAddress.IPv6Any)) listener.Server.DualMode = true;
            // On Unix, .NET sets SO_REUSEADDR when binding, so that a restart need not wait for old connections to time out.
            // Setting it here would also let two gateways share the port.
            listener.Start();
            return listener;
        }
        catch (SocketException e)
        {
            listener?.Dispose();
            throw Refusal(option, bind, port, e);
        }
    }

    /// <summary>Creates the exception for a port that the system refuses.</summary>
    public static IOException Refusal(string option, IPAddress bind, int port, Exception cause) => IsOfThePort(cause)
        ? new IOException($"{option} {port} on {bind}: {cause.Message}", cause)
        : new IOException(AddressOptionMessages.NotThisMachine(bind, cause.Message), cause);

    /// <summary>Whether the port is in use by another process at present.</summary>
    public static bool IsTaken(IOException refusal) =>
        refusal.InnerException is SocketException { SocketErrorCode: SocketError.AddressAlreadyInUse };

    static bool IsOfThePort(Exception cause) =>
        cause is not SocketException refused || refused.SocketErrorCode is SocketError.AddressAlreadyInUse or SocketError.AccessDenied;
}
