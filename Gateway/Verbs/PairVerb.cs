using System.CommandLine;
using System.Globalization;
using System.Net;
using System.Text.Json;
using Nowpose.Gateway.Codes;
using Nowpose.Gateway.Options;
using Nowpose.Network;
using Nowpose.Pairing;

namespace Nowpose.Gateway.Verbs;

/// <summary>The command "pair", which shows the pairing code of a gateway on this machine in the terminal.</summary>
static class PairVerb
{
    static readonly TimeSpan RequestTimeout = TimeSpan.FromSeconds(10);

    public static Command Create()
    {
        var host = TextOption.Create("--host", "Address on which the gateway listens; all except loopback need --token-file", "HOST", "127.0.0.1");
        var tokenFile = TextOption.Create("--token-file", "File that contains only the token of an operator", "FILE");
        var socket = NumberOption.Create("--ws-port", "TCP port of the gateway's WebSocket", ProtocolLimits.WebSocketPort, 1, IPEndPoint.MaxPort, "");
        var pin = new PinArguments();
        var renew = SwitchOption.Create("--renew", "Create a new code; the current code becomes invalid");
        var command = new Command("pair", "Show the code that pairs a headset with the gateway on this machine; usable once, within 5 minutes")
        {
            host, socket, renew, tokenFile,
        };
        pin.AddTo(command);
        command.SetAction(async (parsed, stop) =>
        {
            var key = await Invocation.ReadAsync(() => pin.Read(parsed), stop);
            var token = await Invocation.ReadAsync(() => TokenOf(parsed.GetValue(tokenFile), parsed.GetValue(host), key), stop);
            var uri = new UriBuilder(
                key == null ? Uri.UriSchemeHttp : Uri.UriSchemeHttps, parsed.GetValue(host), parsed.GetValue(socket), PairingLimits.Path + "/code").Uri;
            var (code, left) = await AskAsync(uri, key, token, parsed.GetValue(renew), stop);
            using var drawn = new QrCode(code.Text);
            Console.Out.Write(drawn.Blocks(!Console.IsOutputRedirected && WindowsProcess.ShowsEscapeSequences()));
            Console.Out.WriteLine("code " + code.Text);
            // Prints the same digits of the key as the headset shows.
            if (code.Pin != null) Console.Out.WriteLine("key " + code.Pin.Beginning);
            Console.Out.WriteLine(string.Create(CultureInfo.InvariantCulture, $"valid_s {left:0}"));
        });
        return command;
    }

    // The settings refuse a token that would be sent unencrypted to another machine.
    static string TokenOf(string path, string host, CertificatePin pin) => path == null ? null : new ConnectionSettings(
        host, pin: pin, token: FileFault.Report(() => File.ReadAllText(path).Trim(), e => PathMessages.NotRead($"--token-file {path}", e))).Token;

    static async Task<(TokenCode Code, double LeftSeconds)> AskAsync(
        Uri uri, CertificatePin pin, string token, bool isRenewed, CancellationToken stop)
    {
        string refusal = null;
        var trust = new ServerTrust(pin);
#pragma warning disable CA5399, CA5400 // The pin replaces the check for revocation, which does not exist for a self-signed certificate.
        using var http = new HttpClient(new SocketsHttpHandler
        {
            UseProxy = false,
            AllowAutoRedirect = false,
            SslOptions =
            {
                RemoteCertificateValidationCallback = (_, shown, _, errors) => (refusal = trust.Refusal(shown, errors, DateTime.Now)) == null,
            },
        })
        { Timeout = RequestTimeout };
#pragma warning restore CA5399, CA5400
        if (token != null) http.DefaultRequestHeaders.Authorization = new("Bearer", token);
        try
        {
            using var body = new StringContent(isRenewed ? "{\"renew\":\"\"}" : "{}");
            using var response = await http.PostAsync(uri, body, stop);
            var text = await response.Content.ReadAsStringAsync(stop);
            if (!response.IsSuccessStatusCode)
                throw new IOException(VerbMessages.PairingRefused(uri, (int)response.StatusCode, text.Trim()));
            using var json = JsonDocument.Parse(text);
            return (TokenCode.Parse(json.RootElement.GetProperty("text").GetString()), json.RootElement.GetProperty("left_s").GetDouble());
        }
        catch (Exception e) when (e is HttpRequestException or JsonException or KeyNotFoundException or InvalidOperationException
            || (e is TaskCanceledException && !stop.IsCancellationRequested))
        {
            throw new IOException(VerbMessages.NoGateway(uri, refusal ?? (e.InnerException ?? e).Message), e);
        }
    }
}
