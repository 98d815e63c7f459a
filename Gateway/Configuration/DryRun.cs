using System.Net;
using System.Security.Cryptography.X509Certificates;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Configuration;

/// <summary>Checks the files, folders and ports that a gateway would use, and leaves no changes.</summary>
static class DryRun
{
    /// <param name="path">Path of the certificate. It may be missing; the gateway would create it.</param>
    public static X509Certificate2 Certificate(string path, string keyPath, Findings findings)
    {
        if (!File.Exists(path) && keyPath == null)
        {
            RequireRoom("--certificate", path);
            findings.Good("certificate", $"{path} (would be created)");
            return CertificateFiles.Generate();
        }

        var certificate = CertificateFiles.LoadValid(path, keyPath).Certificate;
        findings.Good("certificate", FormattableString.Invariant($"{path} (valid to {certificate.NotAfter:yyyy-MM-dd})"));
        findings.Good("pin", CertificatePin.Of(certificate).ToString());
        return certificate;
    }

    public static TokenList Tokens(string path, Findings findings)
    {
        var tokens = TokenList.Read(path);
        findings.Good("tokens", path);
        return tokens;
    }

    public static void Pairing(string path, Findings findings)
    {
        // Each change writes a new file, also if the list exists.
        RequireRoom("--pairing", path);
        findings.Good("pairing", File.Exists(path) ? $"{path} ({HeadsetFile.Load(path).Count} headsets)" : $"{path} (would be created)");
    }

    public static void Recordings(string folder, Findings findings)
    {
        if (File.Exists(folder)) throw new InputException(DryRunMessages.RecordingsAreAFile(folder));
        RequireWritable("--recordings", folder, Directory.Exists(folder) ? folder : FolderOf("--recordings", folder));
        findings.Good("recordings", Directory.Exists(folder) ? folder : $"{folder} (would be created)");
    }

    public static void SyncPort(GatewayOptions options, Findings findings)
    {
        var at = new IPEndPoint(options.Bind, options.SyncPort);
        findings.Good("sync", at + Remark("--sync-port", at));
    }

    /// <param name="encrypts">Whether the connections are encrypted, also if the certificate is invalid.</param>
    public static void WebSocketPort(GatewayOptions options, bool encrypts, Findings findings)
    {
        var at = new IPEndPoint(options.Bind, options.WebSocketPort);
        findings.Good("websocket", $"{(encrypts ? "wss" : "ws")}://{at}/{Remark("--ws-port", at)}");
    }

    // A port in use is not a configuration error, because the gateway to be replaced may be using it.
    static string Remark(string option, IPEndPoint at)
    {
        try
        {
            PortListener.Open(option, at.Address, at.Port).Dispose();
            return "";
        }
        catch (IOException refused)
        {
            return PortListener.IsTaken(refused) ? DryRunMessages.PortInUse(at.Port) : throw new InputException(refused.Message, refused);
        }
    }

    static void RequireRoom(string option, string path)
    {
        if (Directory.Exists(path)) throw new InputException(DryRunMessages.IsAFolder(option, path));
        RequireWritable(option, path, FolderOf(option, path));
    }

    static string FolderOf(string option, string path)
    {
        var folder = Path.GetDirectoryName(Path.GetFullPath(path));
        return Directory.Exists(folder) ? folder : throw new InputException(DryRunMessages.NoFolder(option, path, folder));
    }

    static void RequireWritable(string option, string path, string folder) =>
        FileFault.Report(() => OutputFile.TryIn(folder), _ => DryRunMessages.NotWritable(option, path, folder));
}
