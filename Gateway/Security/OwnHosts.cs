using System.Net;
using System.Net.NetworkInformation;
using System.Net.Sockets;

namespace Nowpose.Gateway.Security;

/// <summary>The hosts from which the gateway's own pages can be loaded: addresses and names of this machine.</summary>
static class OwnHosts
{
    /// <param name="origin">Origin of the requesting page; only its host is used.</param>
    /// <param name="local">This machine's address on the page's connection.</param>
    public static bool Contain(Uri origin, IPAddress local)
    {
        if (IPAddress.TryParse(origin.IdnHost, out var address))
            return address.MapToIPv6().Equals(local.MapToIPv6());
        return NamesOf(local).Contains(origin.Host, StringComparer.OrdinalIgnoreCase);
    }

    /// <summary>Gets all hosts that <see cref="Contain"/> accepts on connections to an address, in URL form.</summary>
    public static IEnumerable<string> Of(IPAddress local) => NamesOf(local).Prepend(UrlTextOf(local));

    /// <summary>Gets the hosts of a gateway that listens on an address, as accepted by <see cref="Contain"/> and usable in a browser.</summary>
    public static IEnumerable<string> Reachable(IPAddress bind)
    {
        if (!bind.Equals(IPAddress.Any) && !bind.Equals(IPAddress.IPv6Any)) return [UrlTextOf(bind)];
        // Listening on all IPv6 addresses includes all IPv4 addresses.
        var addresses = AddressesOfThisMachine()
            .Where(address => address.AddressFamily == AddressFamily.InterNetwork || bind.Equals(IPAddress.IPv6Any));
        // The name comes last, because not every network resolves it.
        return addresses.Select(UrlTextOf).Append(Environment.MachineName);
    }

    static IEnumerable<string> NamesOf(IPAddress local) =>
        IPAddress.IsLoopback(local) ? ["localhost", Environment.MachineName] : [Environment.MachineName];

    // Omits link-local IPv6 addresses, because they need the name of an interface, which browsers do not accept.
    static IEnumerable<IPAddress> AddressesOfThisMachine() =>
        from network in NetworkInterface.GetAllNetworkInterfaces()
        where network.OperationalStatus == OperationalStatus.Up && network.NetworkInterfaceType != NetworkInterfaceType.Loopback
        from unicast in network.GetIPProperties().UnicastAddresses
        where !unicast.Address.IsIPv6LinkLocal
        select unicast.Address;

    static string UrlTextOf(IPAddress address)
    {
        var plain = address.IsIPv4MappedToIPv6 ? address.MapToIPv4() : address;
        return plain.AddressFamily == AddressFamily.InterNetworkV6 ? $"[{plain}]" : plain.ToString();
    }
}
