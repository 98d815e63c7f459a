using System.Net;
using System.Net.Sockets;

namespace Nowpose.Gateway;

/// <summary>Opens the gateway's ports. Errors name the option that sets the port or the address.</summary>
static class PortListener
{
    /// <summary>Opens a port.</summary>
    /// <param name="option">Name of the option that sets the port, for messages.</param>
    /// <exception cref="IOException">The port is in use, or the address does not belong to this machine. Both may be temporary.</exception>
    public static TcpListener Open(string option, IPAddress bind, int port)
    {
        TcpListener listener = null;
        try
        {
            listener = new TcpListener(bind, port);
            if (bind.Equals(IPAddress.IPv6Any)) listener.Server.DualMode = true;
            // Does not set the option ReuseAddress. On Unix, .NET sets SO_REUSEADDR when it binds, so a restart need not wait until old connections
            // time out. ReuseAddress also has the effect of SO_REUSEPORT, which would let two gateways share the port.
            // Windows would otherwise let another program listen on the same port at one of the addresses. Other systems always refuse this. Windows
            // then refuses a restart until the connections of the earlier gateway have ended.
            listener.Server.ExclusiveAddressUse = true;
            listener.Start();
            return listener;
        }
        catch (SocketException e)
        {
            listener?.Dispose();
            throw Refusal(option, bind, port, e);
        }
    }

    /// <summary>Whether the port was refused because another process uses it.</summary>
    public static bool IsTaken(IOException refusal) =>
        refusal.InnerException is SocketException { SocketErrorCode: SocketError.AddressAlreadyInUse };

    static IOException Refusal(string option, IPAddress bind, int port, SocketException cause) => new(cause.SocketErrorCode switch
    {
        SocketError.AddressAlreadyInUse => AddressOptionMessages.PortInUse(option, port, bind, cause.Message),
        SocketError.AccessDenied => OperatingSystem.IsWindows()
            ? AddressOptionMessages.PortReserved(option, port, bind, cause.Message)
            : AddressOptionMessages.PortPrivileged(option, port, bind, cause.Message),
        _ => AddressOptionMessages.NotThisMachine(bind, cause.Message),
    }, cause);
}
