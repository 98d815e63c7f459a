namespace Nowpose.Gateway.Security;

/// <summary>Security warnings for the operator of a gateway.</summary>
static class Precautions
{
    const UnixFileMode Group = UnixFileMode.GroupRead | UnixFileMode.GroupWrite;
    const UnixFileMode Others = UnixFileMode.OtherRead | UnixFileMode.OtherWrite;

    /// <summary>Gets the warnings.</summary>
    /// <param name="options">Options of the gateway.</param>
    /// <param name="credentials">Protected folder in which the service manager passes secrets; null if there is none.</param>
    public static IEnumerable<string> Of(GatewayOptions options, string credentials)
    {
        if (Environment.IsPrivilegedProcess)
            yield return PrecautionMessages.Root;
        if (options.Certificate == null && !options.IsLoopback)
            yield return PrecautionMessages.InsecureLan;
        foreach (var name in options.HostNames.Where(name => options.Certificate?.MatchesHostname(name) == false))
            yield return PrecautionMessages.NotInCertificate(name);
        if (options.Headsets != null && options.Tokens.IsEmpty)
            yield return PrecautionMessages.NoOperator(OwnHosts.IsLocalhostReachable(options.Bind));
        foreach (var warning in OfTokens(options.Tokens.Weak))
            yield return warning;
        if (OperatingSystem.IsWindows()) yield break;
        foreach (var path in options.SecretFiles.Where(File.Exists).Where(path => !IsBelow(credentials, path)))
        {
            var mode = File.GetUnixFileMode(path);
            // A file that another user owns, such as root, and that only its owner and the gateway's group can read is as safe as a file of the
            // gateway's user.
            var shared = (mode & Group) == UnixFileMode.GroupRead && FileOwner.IsOthersForOwnGroup(path) ? Others : Others | Group;
            if ((mode & shared) != 0)
                yield return PrecautionMessages.ReadableFile(path, Convert.ToString((int)mode, 8));
        }
    }

    /// <summary>Gets the warnings about tokens that are too easy to guess.</summary>
    /// <param name="weak">File and line of each of these tokens, with its strength in bits.</param>
    public static IEnumerable<string> OfTokens(IEnumerable<(string Where, double Bits)> weak) =>
        weak.Select(one => PrecautionMessages.WeakToken(one.Where, Math.Floor(one.Bits), TokenStrength.MinBits));

    static bool IsBelow(string folder, string path) =>
        !string.IsNullOrEmpty(folder) && Path.GetFullPath(path).StartsWith(folder.TrimEnd('/') + "/", StringComparison.Ordinal);
}
