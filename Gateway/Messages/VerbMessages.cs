namespace Nowpose.Gateway.Messages;

/// <summary>Error messages of the commands cell, pair and pairings, with remedies.</summary>
static class VerbMessages
{
    public static string OutName(string path) => $"--out {path}: the file name must end in .svg or .png";

    public static string PairingRefused(Uri address, int status, string reason) =>
        $"{address}: the gateway responded with status {status} ({reason}); check that it was started with --pairing; an address "
        + "other than loopback also needs --token-file";

    public static string NoGateway(Uri address, string reason) =>
        $"{address}: {reason}; check that the gateway is running; if it uses TLS, add --certificate or --pin";

    public static string NoList(string path) =>
        PathMessages.NotFound($"--pairing {path}", "a gateway that is started with --pairing creates it; start one, or correct the path");
    public static string UnknownHeadset(string name, string known) => $"--revoke '{name}': no headset has this name; the names are {known}";

    public const string PinAndCertificate = "--pin: the certificate already determines the pin; use one of the two";

    public static string NoCertificate(string path) =>
        PathMessages.NotFound($"--certificate {path}", "the gateway creates it at its first start; start the gateway, or correct the path");
}
