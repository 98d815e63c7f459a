using System.Net;
using System.Net.Sockets;

namespace Nowpose.Gateway.Security;

/// <summary>The network of a client, to which all limits for each address apply.</summary>
static class ClientNetwork
{
    const int PrefixBytes = 8;

    /// <summary>
    /// Returns the /64 network of an IPv6 address, because a machine can have any number of addresses in its network; any other address itself.
    /// </summary>
    /// <remarks>
    /// This includes link-local and unique local addresses, because a machine selects them itself. Each link has its own network of link-local
    /// addresses (the scope). An IPv4-mapped address is its IPv4 address.
    /// </remarks>
    /// <param name="address">Address of the client; null if it is unknown. Clients with unknown addresses count as one network.</param>
    public static IPAddress Of(IPAddress address)
    {
        if (address == null) return IPAddress.None;
        if (address.IsIPv4MappedToIPv6) return address.MapToIPv4();
        if (address.AddressFamily != AddressFamily.InterNetworkV6) return address;
        return new IPAddress([.. address.GetAddressBytes().AsSpan(0, PrefixBytes), .. new byte[PrefixBytes]], address.ScopeId);
    }
}
