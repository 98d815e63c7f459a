using System.Net;

namespace Nowpose.Gateway.Messages;

/// <summary>Error messages about options for addresses, ports and encryption, with remedies.</summary>
static class AddressOptionMessages
{
    public static string TokensWithoutTls(IPAddress address) =>
        $"--tokens without --tls on {address}: tokens are sent only over TLS or loopback; add --tls or bind to loopback";

    public static string PairingWithoutCertificate(IPAddress address) =>
        $"--pairing without --certificate on {address}: tokens are sent only over TLS or loopback; add --certificate or bind to loopback";

    public static string PlainBind(IPAddress address) =>
        $"--bind {address}: unencrypted connections from other machines need --insecure-lan; --tls is safer";

    public static string SamePorts(string option, int port) => $"{option} {port}: --sync-port and --ws-port are the same; use two different ports";

    public static string PortInUse(string option, int port, IPAddress address, string reason) =>
        $"{option} {port} on {address}: {reason}; choose another port, or stop the program that uses this one and wait until its connections have ended";

    public static string PortReserved(string option, int port, IPAddress address, string reason) =>
        $"{option} {port} on {address}: {reason}; stop the program that uses this port, or choose a port above 1023 that Windows "
        + "does not reserve (netsh interface ipv4 show excludedportrange protocol=tcp)";

    public static string PortPrivileged(string option, int port, IPAddress address, string reason) =>
        $"{option} {port} on {address}: {reason}; choose a port above 1023";

    public const string KeyWithoutCertificate =
        "--certificate-key: needs --certificate, the file of the certificate; add it, or remove --certificate-key";

    public static string NotThisMachine(IPAddress address, string reason) =>
        $"--bind {address}: not an address of this machine ({reason}); use an IP address of this machine, localhost or any";

    public static string ClockName(string name) =>
        $"--clock: '{name}' is not a valid clock name; allowed: own, or a name of 1 to 32 characters of a-z, 0-9, _ and -.";

    public const string PairingWithTls =
        "--pairing with --tls: headsets accept one key only, and each start would create a new one; add --certificate FILE";

    public const string ClockStart =
        "--clock-start-s: needs --own-clock monotonic, because the system clock shows Unix time. Remove one of the two options";

    public const string Skew =
        "--skew-ppm: needs --own-clock monotonic, because the system clock has its own rate. Remove one of the two options";

    public static string NotAnAddress(string text) => $"--bind: '{text}' is not an address; allowed: an IP address, localhost and any.";
    public static string NotAHost(string text) => $"--host-names: '{text}' is not a host; allowed: names and IP addresses, separated by commas.";
    public static string SecondsOutOfRange(string text, double max) => $"--clock-start-s: '{text}' is out of range; allowed: 0 to {max} s.";
}
