using System.Collections.Concurrent;
using System.Security.Cryptography;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Security;
using Nowpose.Headless.Tests.Gateway.Security;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Faults;

/// <summary>Tests a connected headset when the gateway's certificate expires, or when the headset's token is revoked.</summary>
public class AccessFaultTests
{
    readonly ConcurrentQueue<string> _log = [];
    string _folder;

    [SetUp]
    public void SetUp() => _folder = Directory.CreateTempSubdirectory("nowpose-access").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    [Test]
    public async Task Certificate_Expires_IsReportedOnBothSidesUntilRenewed()
    {
        var path = Path.Combine(_folder, "gateway.pem");
        using var key = ECDsa.Create(ECCurve.NamedCurves.nistP256);
        CertificatesOfOneKey.Write(path, key, days: 100);
        var clock = new StopwatchControlClock(Gateways.Start);
        var options = Gateways.Options() with { CertificateFile = new CertificateFile(path, null, _log.Enqueue) };
        await using var gateway = await GatewayServer.StartAsync(options, clock, _log.Enqueue);
        using var cell = FaultCell.In(gateway.Hub, clock);
        using var sync = new QuietPath(gateway.SyncEndPoint);
        using var positions = new QuietPath(gateway.WebSocketEndPoint);
        using var headset = new FaultHeadset(sync.Port, positions.Port, gateway.Pin);
        await headset.BecomesAsync(PoseState.Current);

        // The certificate is written only now, because it is valid for 10 s, and a busy machine may take longer to connect and synchronise.
        CertificatesOfOneKey.Write(path, key, DateTimeOffset.UtcNow.AddSeconds(10));
        await Soon.BecomesAsync(() => _log.Any(line => line.Contains(EventTexts.CertificateExpired)), "logged by gateway: " + string.Join('\n', _log));
        Assert.That(await ReadinessAsync(gateway), Is.EqualTo(503));
        // Existing connections continue, but a new connection would receive the expired certificate.
        await headset.BecomesAsync(() => headset.IsConnected && headset.State == PoseState.Current, "existing connections continue");
        // Both connections are interrupted, as when the headset leaves the network for a while, so the headset connects again.
        sync.Interrupt();
        positions.Interrupt();
        await headset.BecomesAsync(
            () => headset.State != PoseState.Current && headset.Links.Split("certificate: expired on").Length == 3, "shown by the headset, twice");
        CertificatesOfOneKey.Write(path, key, days: 100);
        var took = await headset.BecomesAsync(PoseState.Current);

        Recovery.Print("certificate expired, from the renewed file to a current pose", took);
        await Soon.BecomesAsync(() => _log.Contains(KeyFileMessages.Renewed(options.CertificateExpires.Value)), "renewal logged");
    }

    [Test]
    public async Task Token_RevokedAndRestored_IsReportedAndTheHeadsetRecovers()
    {
        var path = Path.Combine(_folder, "tokens.txt");
        File.WriteAllText(path, "observer a\nobserver b\n");
        var clock = new StopwatchControlClock(Gateways.Start);
        var options = Gateways.Options() with { Tokens = TokenList.Read(path, _log.Enqueue) };
        await using var gateway = await Gateways.StartAsync(options, clock);
        using var cell = FaultCell.In(gateway.Hub, clock);
        using var headset = new FaultHeadset(gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port, token: "a");
        using var other = new FaultHeadset(gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port, token: "b");
        await headset.BecomesAsync(PoseState.Current);
        await other.BecomesAsync(PoseState.Current);

        File.WriteAllText(path, "observer b\n");
        await headset.BecomesAsync(
            () => headset.State != PoseState.Current && headset.Session.SyncLink.IsTokenRefused && headset.Session.SampleLink.IsTokenRefused,
            "refused on both connections");
        await other.BecomesAsync(() => other.IsConnected && other.State == PoseState.Current, "the other headset continues");
        File.WriteAllText(path, "observer a\nobserver b\n");
        var took = await headset.BecomesAsync(PoseState.Current);

        Recovery.Print("token revoked, from being given back to a current pose", took);
    }

    static async Task<int> ReadinessAsync(GatewayServer gateway)
    {
        using var handler = new HttpClientHandler { ServerCertificateCustomValidationCallback = (_, _, _, _) => true };
        using var http = new HttpClient(handler);
        using var response = await http.GetAsync(new Uri($"https://127.0.0.1:{gateway.WebSocketEndPoint.Port}/readyz")).Bounded();
        return (int)response.StatusCode;
    }
}
