using System.Net;
using System.Net.NetworkInformation;
using System.Net.Sockets;

namespace Nowpose.Gateway.Security;

/// <summary>The hosts that a page of the gateway's own may have been loaded from: addresses and names of this machine.</summary>
static class OwnHosts
{
    /// <param name="origin">Of the page that asks; only its host is looked at.</param>
    /// <param name="local">This machine's address on the page's connection.</param>
    public static bool Contain(Uri origin, IPAddress local)
    {
        if (IPAddress.TryParse(origin.IdnHost, out var address))
            return address.MapToIPv6().Equals(local.MapToIPv6());
        return NamesOf(local).Contains(origin.Host, StringComparer.OrdinalIgnoreCase);
    }

    /// <summary>All that <see cref="Contain"/> accepts on connections to an address, as they stand in an URL.</summary>
    public static IEnumerable<string> Of(IPAddress local) => NamesOf(local).Prepend(UrlTextOf(local));

    /// <summary>Under which a gateway is found that listens there: what <see cref="Contain"/> accepts, and a browser can open.</summary>
    public static IEnumerable<string> Reachable(IPAddress bind)
    {
        if (!bind.Equals(IPAddress.Any) && !bind.Equals(IPAddress.IPv6Any)) return [UrlTextOf(bind)];
        // Listening on all of IPv6 is listening on all of IPv4 as well.
        var addresses = AddressesOfThisMachine()
            .Where(address => address.AddressFamily == AddressFamily.InterNetwork || bind.Equals(IPAddress.IPv6Any));
        // The name last: not every network knows it.
        return addresses.Select(UrlTextOf).Append(Environment.MachineName);
    }

    static IEnumerable<string> NamesOf(IPAddress local) =>
        IPAddress.IsLoopback(local) ? ["localhost", Environment.MachineName] : [Environment.MachineName];

    // Of IPv6 not those of one link alone: they need the name of an interface, which browsers do not take.
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
