namespace Nowpose.Gateway.Messages;

/// <summary>Error messages and warnings about the certificate and its file, with remedies.</summary>
static class KeyFileMessages
{
    public static string OtherKey(string path, CertificatePin pin) =>
        $"{path}: has a different key (pin {pin}), which paired headsets refuse; restore the former key, or restart the gateway and pair "
        + "the headsets again";

    public static string NotYetValid(string path, DateTime from, DateTime now) =>
        FormattableString.Invariant($"{path}: not valid before {from:yyyy-MM-dd HH:mm}, but this machine's time is {now:yyyy-MM-dd HH:mm}; ")
        + "set the machine's clock";

    public static string Expired(string path, DateTime to, DateTime now) =>
        FormattableString.Invariant($"{path}: expired on {to:yyyy-MM-dd} (this machine's date: {now:yyyy-MM-dd}); renew it with the same key; ")
        + "a new key would make all pairings invalid";

    public static string Unusable(string path, string reason) =>
        $"{path}: no usable certificate with private key ({reason}); allowed: a .pfx file without a password, or a .pem file";

    public static string NoPrivateKey(string path) => $"{path}: the certificate has no private key; use a certificate with its private key";

    public static string NotWritten(string path, string reason) =>
        $"{path}: the new certificate cannot be written ({reason}); check the folder's permissions";

    /// <param name="until">Expiry of the new certificate, UTC.</param>
    public static string Renewed(DateTime until) => FormattableString.Invariant($"certificate: renewed, valid to {until:yyyy-MM-dd HH:mm} UTC");
}
