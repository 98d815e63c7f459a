using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Net;
using System.Security.Cryptography.X509Certificates;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Configuration;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Verbs;

/// <summary>The options of all commands that start a gateway: addresses and ports, access, recordings, and the control clock.</summary>
/// <param name="configured">The entries of the configuration file.</param>
sealed class ServerArguments(ConfiguredArguments configured)
{
    readonly Option<IPAddress> _bind = new("--bind")
    {
        Description = "Address to listen on: an IP address, localhost, any for all IPv4 addresses of this machine, or :: for all IPv4 and IPv6 addresses",
        HelpName = "ADDRESS",
        DefaultValueFactory = _ => IPAddress.Loopback,
        CustomParser = ParseAddress,
    };

    readonly Option<int> _syncPort = NumberOption.Create(
        "--sync-port", "TCP port of the clock synchronisation; 0: any free port", ProtocolLimits.SyncPort, 0, IPEndPoint.MaxPort, "");

    readonly Option<int> _webSocketPort = NumberOption.Create(
        "--ws-port", "TCP port of the WebSocket; 0: any free port", ProtocolLimits.WebSocketPort, 0, IPEndPoint.MaxPort, "");

    readonly Option<IReadOnlyList<string>> _hostNames = new("--host-names")
    {
        Description = "Other host names or addresses of this machine, separated by commas: browsers may open the pages under them, and a new "
            + "certificate contains them",
        HelpName = "NAMES",
        DefaultValueFactory = _ => [],
        CustomParser = ParseHostNames,
    };

    readonly Option<bool> _tls = SwitchOption.Create(
        "--tls", "Encrypt both connections; without --certificate, the gateway creates a certificate at each start");

    readonly Option<string> _certificate = TextOption.Create(
        "--certificate", "Certificate with private key, .pfx without password or .pem; created if the file does not exist. Implies --tls", "FILE");

    readonly Option<string> _key = TextOption.Create("--certificate-key", ".pem file of the private key, if separate", "FILE");

    readonly Option<string> _tokens = TextOption.Create(
        "--tokens", "File of the clients' tokens: lines \"observer TOKEN\", \"source TOKEN\" or \"operator TOKEN\"; changes apply immediately",
        "FILE");

    readonly Option<string> _pairing = TextOption.Create(
        "--pairing", "Allow pairing, with the list of headsets in this file, which is created if it does not exist. Clients then need a token",
        "FILE");

    readonly Option<string> _cell = TextOption.Create(
        "--cell", "Name of the cell, used as the title of the pages and at the start of the recordings' names", "NAME");

    readonly Option<string> _recordings = TextOption.Create(
        "--recordings", "Folder for recordings, which start and stop on the operations page; created if it does not exist", "FOLDER");

    readonly Option<bool> _record = SwitchOption.Create("--record", "Record from the start of the gateway");

    readonly Option<bool> _insecureLan = SwitchOption.Create(
        "--insecure-lan", "Allow unencrypted connections from other machines. Use it only on a trusted network");

    readonly Option<int> _maxConnections = NumberOption.Create("--max-connections", "Maximum number of connections to each of the two ports", 256, 1, 10_000, "");

    readonly Option<double> _skew = NumberOption.Create(
        "--skew-ppm", "Rate error of the control clock; headsets would interpret a larger error as clock steps", 0.0, -500, 500, "ppm");

    readonly Option<double?> _clockStart = new("--clock-start-s")
    {
        Description = "Time of the control clock at startup, s [default: Unix time]",
        HelpName = "SECONDS",
        CustomParser = ParseSeconds,
    };

    readonly Option<string> _config = TextOption.Create(
        ConfiguredArguments.Option, "Read options from a .yaml file with one \"name: value\" per line; options of the command line take precedence",
        "FILE");

    readonly Option<bool> _check = SwitchOption.Create(
        ConfiguredArguments.Check, "Check the configuration, print what would be served, and exit without changing anything");

    public void AddTo(Command command)
    {
        foreach (var option in new Option[]
            {
                _config, _check, _bind, _syncPort, _webSocketPort, _hostNames, _tls, _certificate, _key, _tokens, _pairing, _cell, _recordings, _record,
                _insecureLan, _maxConnections, _clockStart, _skew,
            })
            command.Options.Add(option);
    }

    /// <summary>Whether to check the configuration only, without serving.</summary>
    public bool IsCheck(ParseResult parsed) => parsed.GetValue(_check);

    /// <summary>Checks the arguments and gets the options like <see cref="Options"/>, but without creating or writing a file.</summary>
    public GatewayOptions Check(ParseResult parsed, Findings findings)
    {
        var (tokens, certificate) = (parsed.GetValue(_tokens), parsed.GetValue(_certificate));
        var (pairing, recordings) = (parsed.GetValue(_pairing), parsed.GetValue(_recordings));
        var options = new GatewayOptions
        {
            Bind = parsed.GetValue(_bind),
            SyncPort = parsed.GetValue(_syncPort),
            WebSocketPort = parsed.GetValue(_webSocketPort),
            Certificate = !configured.AreKnown(_certificate, _key) ? null : findings.Try(() => certificate != null
                ? DryRun.Certificate(certificate, parsed.GetValue(_key), findings) : Certificate(parsed)),
            Tokens = tokens == null ? TokenList.None : findings.Try(() => DryRun.Tokens(tokens, findings)) ?? TokenList.None,
            // The rules about tokens and pairing take precedence.
            AllowInsecureLan = parsed.GetValue(_insecureLan) || !configured.AreKnown(_insecureLan, _tokens, _pairing),
            MaxConnections = parsed.GetValue(_maxConnections),
        };
        if (pairing != null) findings.Try(() => DryRun.Pairing(pairing, findings));
        if (recordings != null) findings.Try(() => DryRun.Recordings(recordings, findings));
        // Skips the rules about options whose entries in the file are invalid, because the rules would report consequences of these errors.
        else if (Records(parsed) && configured.AreKnown(_recordings)) findings.Try(() => Recordings(parsed));
        if (configured.AreKnown(_certificate)) findings.Try(() => CheckPairing(parsed));
        if (IsEncryptionKnown) findings.Try(() => options.CheckEncryption(Encrypts(parsed), tokens != null, pairing != null));
        if (configured.AreKnown(_syncPort, _webSocketPort)) findings.Try(options.CheckPorts);
        if (configured.AreKnown(_maxConnections)) findings.Try(options.CheckConnections);
        // Omits an address if an entry that determines it is invalid, because the line would contain a default.
        if (configured.AreKnown(_bind, _syncPort)) findings.Try(() => DryRun.SyncPort(options, findings));
        if (configured.AreKnown(_webSocketPort) && IsEncryptionKnown) findings.Try(() => DryRun.WebSocketPort(options, Encrypts(parsed), findings));
        return options;
    }

    /// <summary>Whether no error in the configuration file concerns the address and the encryption of connections.</summary>
    public bool IsEncryptionKnown => configured.AreKnown(_bind, _tls, _certificate);

    /// <summary>Whether the arguments select encrypted connections, also if the certificate is invalid.</summary>
    public bool Encrypts(ParseResult parsed) => parsed.GetValue(_tls) || parsed.GetValue(_certificate) != null;

    /// <summary>Gets the options of the gateway. Reads the files, and creates missing files and folders.</summary>
    /// <exception cref="InputException">A file is invalid.</exception>
    public GatewayOptions Options(ParseResult parsed)
    {
        var tokens = parsed.GetValue(_tokens);
        return new GatewayOptions
        {
            Bind = parsed.GetValue(_bind),
            SyncPort = parsed.GetValue(_syncPort),
            WebSocketPort = parsed.GetValue(_webSocketPort),
            HostNames = parsed.GetValue(_hostNames),
            Certificate = Certificate(parsed),
            CertificateFile = CertificateFile(parsed),
            Tokens = tokens == null ? TokenList.None : TokenList.Read(tokens, Announcement.LogWithTime),
            Headsets = Headsets(parsed),
            Cell = parsed.GetValue(_cell),
            Recordings = Recordings(parsed),
            AllowInsecureLan = parsed.GetValue(_insecureLan),
            MaxConnections = parsed.GetValue(_maxConnections),
        };
    }

    HeadsetList Headsets(ParseResult parsed)
    {
        CheckPairing(parsed);
        return parsed.GetValue(_pairing) is { } path ? new HeadsetList(path, log: Announcement.LogWithTime) : null;
    }

    void CheckPairing(ParseResult parsed)
    {
        var path = parsed.GetValue(_pairing);
        // Without a certificate file, the gateway would have a new key after each restart, and paired headsets would refuse it.
        if (path != null && parsed.GetValue(_tls) && parsed.GetValue(_certificate) == null)
            throw new InputException(AddressOptionMessages.PairingWithTls);
    }

    /// <summary>Whether to enable the recorder at startup.</summary>
    public bool Records(ParseResult parsed) => parsed.GetValue(_record);

    string Recordings(ParseResult parsed)
    {
        var folder = parsed.GetValue(_recordings);
        if (folder == null && Records(parsed))
            throw new InputException(RecorderMessages.RecordWithoutFolder);
        return folder == null ? null
            : FileFault.Report(() => Directory.CreateDirectory(folder).FullName, e => RecorderMessages.FolderNotCreated(folder, e.Message));
    }

    public StopwatchControlClock Clock(ParseResult parsed)
    {
        var skew = SkewPpm(parsed) * 1e-6;
        return parsed.GetValue(_clockStart) is { } start
            ? new StopwatchControlClock(ControlTime.FromSeconds(start), skew) : StopwatchControlClock.FromUnixTime(skew);
    }

    /// <summary>Gets the gateway's own clock.</summary>
    /// <param name="parsed">The arguments.</param>
    /// <param name="isSystem">Whether to use the system clock.</param>
    /// <exception cref="InputException">The system clock was chosen together with an option that it does not support.</exception>
    public IControlClock Clock(ParseResult parsed, bool isSystem)
    {
        if (!isSystem) return Clock(parsed);
        var faults = SystemClockFaults(parsed).ToArray();
        return faults.Length == 0 ? new SystemControlClock() : throw new WrongEntriesException(faults);
    }

    IEnumerable<string> SystemClockFaults(ParseResult parsed)
    {
        if (parsed.GetValue(_clockStart) != null) yield return AddressOptionMessages.ClockStart;
        if (SkewPpm(parsed) != 0) yield return AddressOptionMessages.Skew;
    }

    public double SkewPpm(ParseResult parsed) => parsed.GetValue(_skew);

    X509Certificate2 Certificate(ParseResult parsed)
    {
        if (parsed.GetValue(_certificate) != null) return null;
        if (parsed.GetValue(_key) != null)
            throw new InputException(AddressOptionMessages.KeyWithoutCertificate);
        return parsed.GetValue(_tls) ? CertificateFiles.Generate(parsed.GetValue(_hostNames)) : null;
    }

    CertificateFile CertificateFile(ParseResult parsed) => parsed.GetValue(_certificate) is { } path
        ? new CertificateFile(path, parsed.GetValue(_key), Announcement.LogWithTime, parsed.GetValue(_hostNames)) : null;

    static IPAddress ParseAddress(ArgumentResult result)
    {
        var text = result.Tokens.Count == 1 ? result.Tokens[0].Value : "";
        if (text == "localhost")
            return IPAddress.Loopback;
        if (text == "any")
            return IPAddress.Any;
        if (!IPAddress.TryParse(text, out var address))
            result.AddError(AddressOptionMessages.NotAnAddress(text));
        return address;
    }

    static IReadOnlyList<string> ParseHostNames(ArgumentResult result)
    {
        var names = result.Tokens.SelectMany(token => token.Value.Split(',', StringSplitOptions.TrimEntries)).ToArray();
        var wrong = Array.Find(names, name => Uri.CheckHostName(name) == UriHostNameType.Unknown);
        if (wrong != null) result.AddError(AddressOptionMessages.NotAHost(wrong));
        return wrong != null ? [] : [.. names.Select(name => new UriBuilder(Uri.UriSchemeHttp, name).Uri.IdnHost)];
    }

    static double? ParseSeconds(ArgumentResult result)
    {
        const double Last = 4294967295; // The maximum of a time stamp in ROS.
        var text = result.Tokens.Count == 1 ? result.Tokens[0].Value : "";
        if (double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var value) && value >= 0 && value <= Last)
            return value;
        result.AddError(AddressOptionMessages.SecondsOutOfRange(text, Last));
        return null;
    }
}
