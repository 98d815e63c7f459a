using System.Net;
using System.Net.NetworkInformation;
using System.Net.Sockets;

namespace Nowpose.Gateway.Security;

/// <summary>The hosts of the gateway's own pages: addresses and names of this machine.</summary>
static class OwnHosts
{
    /// <summary>Names of this machine, the complete one last. On Windows, the first name has at most 15 characters.</summary>
    public static IReadOnlyList<string> MachineNames { get; } =
        [.. new[] { Environment.MachineName, Dns.GetHostName() }.Distinct(StringComparer.OrdinalIgnoreCase)];

    /// <summary>Whether a page comes from this machine.</summary>
    /// <param name="origin">Origin of the page. Only its host is compared.</param>
    /// <param name="local">Local address of the connection on which the page sends its request.</param>
    /// <param name="others">Other names and addresses of this machine, from the gateway's options.</param>
    public static bool Contain(Uri origin, IPAddress local, IReadOnlyList<string> others)
    {
        if (others.Contains(origin.IdnHost, StringComparer.OrdinalIgnoreCase)) return true;
        if (IPAddress.TryParse(origin.IdnHost, out var address))
            return address.MapToIPv6().Equals(local.MapToIPv6());
        return NamesOf(local).Contains(origin.Host, StringComparer.OrdinalIgnoreCase);
    }

    /// <summary>Gets all hosts that <see cref="Contain"/> accepts on connections to a local address, as written in URLs.</summary>
    public static IEnumerable<string> Of(IPAddress local, IReadOnlyList<string> others) => NamesOf(local)
        .Concat(others.Select(other => IPAddress.TryParse(other, out var address) ? UrlTextOf(address) : other)).Prepend(UrlTextOf(local));

    /// <summary>Whether a gateway that listens on an address listens on all addresses of this machine.</summary>
    public static bool IsAny(IPAddress bind) => bind.Equals(IPAddress.Any) || bind.Equals(IPAddress.IPv6Any);

    /// <summary>Whether a client on this machine reaches a gateway at localhost that listens on an address.</summary>
    public static bool IsLocalhostReachable(IPAddress bind) => IsAny(bind) || IPAddress.IsLoopback(bind);

    /// <summary>
    /// Whether this machine has an address. If it does not, sockets that listen on the address accept no connections, and report no error.
    /// </summary>
    public static bool IsOfThisMachine(IPAddress address)
    {
        try
        {
            using var socket = new Socket(address.AddressFamily, SocketType.Dgram, ProtocolType.Udp);
            socket.Bind(new IPEndPoint(address, 0));
            return true;
        }
        catch (SocketException e)
        {
            // Any other error, such as too few file descriptors, has nothing to do with the address.
            return e.SocketErrorCode is not (SocketError.AddressNotAvailable or SocketError.AddressFamilyNotSupported);
        }
    }

    /// <summary>Gets the hosts under which browsers can open the pages of a gateway that listens on an address.</summary>
    public static IEnumerable<string> Reachable(IPAddress bind)
    {
        if (!IsAny(bind)) return [UrlTextOf(bind)];
        // A gateway that listens on all IPv6 addresses also listens on all IPv4 addresses.
        var addresses = AddressesOfThisMachine()
            .Where(address => address.AddressFamily == AddressFamily.InterNetwork || bind.Equals(IPAddress.IPv6Any));
        // Returns the machine's name last, because some networks do not resolve it.
        return addresses.Select(UrlTextOf).Append(MachineNames[^1]);
    }

    /// <summary>
    /// Gets the addresses of this machine, without those of loopback and without link-local IPv6 addresses, because the latter need the name of a
    /// network interface, and browsers do not accept them. The first ones are those that other machines most probably reach.
    /// </summary>
    public static IEnumerable<IPAddress> AddressesOfThisMachine() =>
        from network in NetworkInterface.GetAllNetworkInterfaces()
        where network.OperationalStatus == OperationalStatus.Up && network.NetworkInterfaceType != NetworkInterfaceType.Loopback
        let properties = network.GetIPProperties()
        from unicast in properties.UnicastAddresses
        where !unicast.Address.IsIPv6LinkLocal
        // The networks of virtual machines and containers have no default gateway.
        orderby IsLinkLocal(unicast.Address), properties.GatewayAddresses.Count == 0
        select unicast.Address;

    // 169.254.0.0/16, which an interface without a DHCP server has.
    static bool IsLinkLocal(IPAddress address) => address.AddressFamily == AddressFamily.InterNetwork && address.GetAddressBytes() is [169, 254, ..];

    // Multicast DNS resolves the name with the suffix .local to this machine.
    static IEnumerable<string> NamesOf(IPAddress local) =>
        [.. IPAddress.IsLoopback(local) ? ["localhost"] : Array.Empty<string>(), .. MachineNames, MachineNames[0] + ".local"];

    static string UrlTextOf(IPAddress address)
    {
        var plain = address.IsIPv4MappedToIPv6 ? address.MapToIPv4() : address;
        return plain.AddressFamily == AddressFamily.InterNetworkV6 ? $"[{plain}]" : plain.ToString();
    }
}
