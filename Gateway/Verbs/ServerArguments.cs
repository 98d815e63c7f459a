using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Net;
using System.Security.Cryptography.X509Certificates;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Verbs;

/// <summary>The options that all verbs have: where to listen, who may come, and the control clock.</summary>
sealed class ServerArguments
{
    readonly Option<IPAddress> _bind = new("--bind")
    {
        Description = "Address to listen on: an IP address, localhost, or any for all of this machine's",
        HelpName = "ADDRESS",
        DefaultValueFactory = _ => IPAddress.Loopback,
        CustomParser = ParseAddress,
    };

    readonly Option<int> _syncPort = NumberOption.Create(
        "--sync-port", "TCP port of the clock sync; 0 takes a free one", ProtocolLimits.SyncPort, 0, IPEndPoint.MaxPort, "");

    readonly Option<int> _webSocketPort = NumberOption.Create(
        "--ws-port", "Port of the WebSocket; 0 takes a free one", ProtocolLimits.WebSocketPort, 0, IPEndPoint.MaxPort, "");

    readonly Option<bool> _tls = new("--tls") { Description = "Encrypt both connections; without --certificate with one made at each start" };

    readonly Option<string> _certificate = new("--certificate")
    {
        Description = "Certificate with private key, .pfx without password or .pem; made there when the file does not exist. Implies --tls",
        HelpName = "FILE",
    };

    readonly Option<string> _key = new("--certificate-key")
    {
        Description = "The .pem file of the private key, when it is one of its own", HelpName = "FILE",
    };

    readonly Option<string> _tokens = new("--tokens")
    {
        Description = "Tokens that clients must have: lines \"observer TOKEN\" or \"source TOKEN\", # for comments",
        HelpName = "FILE",
    };

    readonly Option<string> _pairing = new("--pairing")
    {
        Description = "Pair headsets, and keep the list of them there; made when the file does not exist. Clients then need a token",
        HelpName = "FILE",
    };

    readonly Option<string> _cell = new("--cell")
    {
        Description = "Name of the cell, which the page of pairing begins with", HelpName = "NAME",
    };

    readonly Option<bool> _insecureLan = new("--insecure-lan")
    {
        Description = "Allow plain connections from other machines: on a trusted network only",
    };

    readonly Option<int> _maxConnections = NumberOption.Create("--max-connections", "Connections to each of the two ports", 64, 1, 10_000, "");

    readonly Option<double> _skew = NumberOption.Create(
        "--skew-ppm", "Rate error of the control clock; beyond this range headsets would take it for steps", 0.0, -500, 500, "ppm");

    readonly Option<double?> _clockStart = new("--clock-start-s")
    {
        Description = "What the control clock shows at the start, s [default: Unix time]",
        HelpName = "SECONDS",
        CustomParser = ParseSeconds,
    };

    public void AddTo(Command command)
    {
        foreach (var option in new Option[]
            { _bind, _syncPort, _webSocketPort, _tls, _certificate, _key, _tokens, _pairing, _cell, _insecureLan, _maxConnections, _clockStart, _skew })
            command.Options.Add(option);
    }

    /// <exception cref="InputException">A file cannot be used.</exception>
    public GatewayOptions Options(ParseResult parsed)
    {
        var tokens = parsed.GetValue(_tokens);
        return new GatewayOptions
        {
            Bind = parsed.GetValue(_bind),
            SyncPort = parsed.GetValue(_syncPort),
            WebSocketPort = parsed.GetValue(_webSocketPort),
            Certificate = Certificate(parsed),
            Tokens = tokens == null ? TokenList.None : TokenList.Read(tokens),
            Headsets = Headsets(parsed),
            Cell = parsed.GetValue(_cell),
            AllowInsecureLan = parsed.GetValue(_insecureLan),
            MaxConnections = parsed.GetValue(_maxConnections),
        };
    }

    HeadsetList Headsets(ParseResult parsed)
    {
        var path = parsed.GetValue(_pairing);
        if (path == null && parsed.GetValue(_cell) != null)
            throw new InputException("--cell: belongs to --pairing, which is missing");
        // What was paired with the key of one run would take the next one for another gateway.
        if (path != null && parsed.GetValue(_tls) && parsed.GetValue(_certificate) == null)
            throw new InputException("--pairing with --tls: headsets trust one key, and each start makes another; add --certificate FILE");
        return path == null ? null : new HeadsetList(path, log: Announcement.Log);
    }

    public StopwatchControlClock Clock(ParseResult parsed)
    {
        var skew = SkewPpm(parsed) * 1e-6;
        return parsed.GetValue(_clockStart) is { } start
            ? new StopwatchControlClock(ControlTime.FromSeconds(start), skew) : StopwatchControlClock.FromUnixTime(skew);
    }

    public double SkewPpm(ParseResult parsed) => parsed.GetValue(_skew);

    X509Certificate2 Certificate(ParseResult parsed)
    {
        var path = parsed.GetValue(_certificate);
        var key = parsed.GetValue(_key);
        if (path != null)
            return CertificateFiles.LoadOrGenerate(path, key);
        if (key != null)
            throw new InputException("--certificate-key: belongs to a --certificate, which is missing");
        return parsed.GetValue(_tls) ? CertificateFiles.Generate() : null;
    }

    static IPAddress ParseAddress(ArgumentResult result)
    {
        var text = result.Tokens.Count == 1 ? result.Tokens[0].Value : "";
        if (text == "localhost")
            return IPAddress.Loopback;
        if (text == "any")
            return IPAddress.Any;
        if (!IPAddress.TryParse(text, out var address))
            result.AddError($"--bind: '{text}' is not an address; allowed are an IP address, localhost and any.");
        return address;
    }

    static double? ParseSeconds(ArgumentResult result)
    {
        const double Last = 4294967295; // what ROS can say
        var text = result.Tokens.Count == 1 ? result.Tokens[0].Value : "";
        if (double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var value) && value >= 0 && value <= Last)
            return value;
        result.AddError($"--clock-start-s: '{text}' is out of range; allowed are 0 to {Last} s.");
        return null;
    }
}
