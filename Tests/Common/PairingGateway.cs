using System.Net;
using System.Security.Cryptography.X509Certificates;
using System.Text;
using System.Text.Json;
using Nowpose.Gateway;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;
using Nowpose.Network;
using Nowpose.Pairing;

namespace Nowpose.Tests.Common;

/// <summary>Runs a gateway on loopback that pairs headsets. Its list of headsets is in a temporary folder.</summary>
sealed class PairingGateway : IAsyncDisposable
{
    readonly HttpClient _http;
    readonly X509Certificate2 _certificate;

    PairingGateway(bool isSecure)
    {
        _certificate = isSecure ? CertificateFiles.Generate() : null;
#pragma warning disable CA5399, CA5400 // One fixed certificate without a revocation list.
        _http = new HttpClient(new SocketsHttpHandler
        {
            SslOptions =
            {
                RemoteCertificateValidationCallback = (_, shown, _, _) => shown?.GetCertHashString() == _certificate?.GetCertHashString(),
            },
        });
#pragma warning restore CA5399, CA5400
    }

    public string Folder { get; } = Directory.CreateTempSubdirectory("nowpose-gateway-").FullName;
    public string ListPath => Path.Combine(Folder, "headsets.txt");
    public SteppedTime Time { get; } = new();
    public List<string> Log { get; } = [];
    public GatewayServer Server { get; private set; }

    public static async Task<PairingGateway> StartAsync(bool isSecure = true, TokenList tokens = null)
    {
        var gateway = new PairingGateway(isSecure);
        await gateway.StartServerAsync(tokens);
        return gateway;
    }

    public async Task RestartAsync()
    {
        await Server.DisposeAsync();
        await StartServerAsync(null);
    }

    /// <summary>Returns the cell code that a headset reads from the robot's marker.</summary>
    public CellCode CellCode() => new(
        "press", "127.0.0.1", Server.Pin, MarkerOffset.Parse("0.5,0,0", ""), 0.1, Server.SyncEndPoint.Port, Server.WebSocketEndPoint.Port);

    /// <summary>Requests the token code that the gateway's page shows.</summary>
    public async Task<TokenCode> ShownAsync(bool isRenewed = false)
    {
        var (status, text) = await PostAsync("/pair/code", isRenewed ? "{\"renew\":\"\"}" : "{}");
        if (status != HttpStatusCode.OK) throw new InvalidOperationException($"{status}: {text}");
        return TokenCode.Parse(JsonDocument.Parse(text).RootElement.GetProperty("text").GetString());
    }

    public Task<PairingAnswer> ExchangeAsync(string token, string name = "headset 7", ConnectionSettings connection = null) =>
        PairingRequest.SendAsync(connection ?? CellCode().ToConnection(null, name), token, CancellationToken.None).Bounded();

    /// <summary>Sends a request as a browser on this machine does.</summary>
    public async Task<(HttpStatusCode Status, string Text)> PostAsync(string path, string body, params (string Name, string Value)[] headers)
    {
        using var content = new StringContent(body, Encoding.UTF8, "application/json");
        return await SendAsync(HttpMethod.Post, path, content, headers);
    }

    public async Task<(HttpStatusCode Status, string Text)> SendAsync(
        HttpMethod method, string path, HttpContent content = null, params (string Name, string Value)[] headers)
    {
        var scheme = Server.Pin == null ? "http" : "https";
        var uri = new Uri($"{scheme}://127.0.0.1:{Server.WebSocketEndPoint.Port}{path}");
        using var request = new HttpRequestMessage(method, uri) { Content = content };
        foreach (var (name, value) in headers) request.Headers.TryAddWithoutValidation(name, value);
        using var response = await _http.SendAsync(request).Bounded();
        return (response.StatusCode, await response.Content.ReadAsStringAsync().Bounded());
    }

    /// <summary>Sends a request and returns the cookie in the response.</summary>
    public async Task<string> CookieOfAsync(string path, HttpContent content)
    {
        var uri = new Uri($"{(Server.Pin == null ? "http" : "https")}://127.0.0.1:{Server.WebSocketEndPoint.Port}{path}");
        using var response = await _http.PostAsync(uri, content).Bounded();
        return response.Headers.GetValues("Set-Cookie").Single();
    }

    public async ValueTask DisposeAsync()
    {
        _http.Dispose();
        await Server.DisposeAsync();
        _certificate?.Dispose();
        Directory.Delete(Folder, true);
    }

    async Task StartServerAsync(TokenList tokens) => Server = await GatewayServer.StartAsync(
        Gateways.Options() with
        {
            Certificate = _certificate,
            Headsets = new HeadsetList(ListPath, Time, Say),
            Tokens = tokens ?? TokenList.None,
            Time = Time,
            Cell = "press",
        },
        new Nowpose.Gateway.Clock.StopwatchControlClock(Gateways.Start), Say).Bounded();

    void Say(string line)
    {
        lock (Log) Log.Add(line);
    }
}
