namespace Nowpose.Gateway.Messages;

/// <summary>Warnings about insecure settings, tokens and files, which the gateway logs at startup, with remedies.</summary>
static class PrecautionMessages
{
    public const string Root = "security: the gateway runs as root or administrator, but does not need these rights; run it as a separate user";

    public const string InsecureLan =
        "security: anyone on this network can read and change the data, because of --insecure-lan; use --tls instead";

    public static string NotInCertificate(string name) =>
        $"certificate: it does not contain {name} of --host-names, so clients that connect to {name} without a pin refuse it; renew it with this "
        + "name and the same key";

    /// <param name="isLocalhostReachable">Whether a browser on this machine can open the pairing page at localhost without a token.</param>
    public static string NoOperator(bool isLocalhostReachable) =>
        $"pairing: clients need a token, but no token opens {(isLocalhostReachable ? "" : "the pairing page, ")}the operations page and the page "
        + "/vlc; add --tokens FILE, a file with a line: operator TOKEN";

    public static string WeakToken(string where, double bits, double min) =>
        $"security: {where}: the token has a strength of {bits} bits and can be guessed; {min} bits or more are needed; replace it, for "
        + "example with the output of: openssl rand -hex 32, or in PowerShell: [guid]::NewGuid().ToString('N')";

    public static string ReadableFile(string path, string mode) =>
        $"security: {path} can be read by users other than its owner (mode {mode}); chmod 600 {path}";
}
