using System.Buffers.Binary;
using System.Collections.Concurrent;
using System.Net;
using System.Net.Security;
using System.Net.Sockets;
using System.Security.Cryptography.X509Certificates;
using System.Text;
using Nowpose.Gateway;
using Nowpose.Gateway.Security;
using Nowpose.Headless.Tests.Gateway;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>Runs the cases of the Autobahn test suite that depend on our code against the gateway and against both clients.</summary>
public class AutobahnTests
{
    const string Marker = "marker";
    static readonly string[] Subjects = ["gateway", "link over ws", "link over wss with a pin"];

    GatewayServer _gateway;
    X509Certificate2 _certificate;

    [OneTimeSetUp]
    public async Task StartAsync()
    {
        _certificate = CertificateFiles.Generate();
        _gateway = await Gateways.StartAsync();
        await HandshakeAsync(_certificate);
    }

    // Compiles the code of a TLS handshake. On a busy machine, this takes longer than the link waits for its first handshake.
    static async Task HandshakeAsync(X509Certificate2 certificate)
    {
        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        using var client = new TcpClient();
        await client.ConnectAsync((IPEndPoint)listener.LocalEndpoint);
        using var accepted = await listener.AcceptTcpClientAsync();
        await using var server = new SslStream(accepted.GetStream());
        await using var headset = new SslStream(client.GetStream(), false, (_, _, _, _) => true);
        await Task.WhenAll(server.AuthenticateAsServerAsync(certificate), headset.AuthenticateAsClientAsync("localhost")).Bounded();
    }

    [OneTimeTearDown]
    public async Task StopAsync()
    {
        await _gateway.DisposeAsync();
        _certificate.Dispose();
    }

    static IEnumerable<TestCaseData> Cases() =>
        from subject in Subjects
        from section in AutobahnDocument.Sections
        from one in section.Cases
        select new TestCaseData(subject, one).SetName($"Autobahn {one.Number}, {subject}");

    [TestCaseSource(nameof(Cases))]
    public async Task Play_AutobahnCase_GivesTheExpectedEvents(string kind, AutobahnCase one)
    {
        await using var subject = await OpenAsync(kind);
        var seen = new ConcurrentQueue<string>();
        subject.Saw = seen.Enqueue;
        var script = subject.NewScript();
        var reading = subject.Peer.ReadAsync();
        var watching = WatchAsync(subject, script, seen);

        one.Play(script);
        await subject.Peer.SendAsync(script);
        if (one.Ends)
        {
            await Task.WhenAll(reading, watching).Bounded();
        }
        else
        {
            var expected = one.Expected.Split(' ', StringSplitOptions.RemoveEmptyEntries).Length;
            script.Chop = 0;
            script.Send(Marker);
            await subject.Peer.SendAsync(script);
            await Soon.BecomesAsync(() => seen.Count >= expected + 1, () => $"{expected} events and the marker; seen: {string.Join(' ', seen)}");
            Assert.That(Sorted(string.Join(' ', seen)), Is.EqualTo(Sorted(one.Expected + " accepted")));
            return;
        }

        Assert.That(one.Expected.Split('|').Select(Sorted), Does.Contain(Sorted(string.Join(' ', seen))));
    }

    [Test]
    public async Task Upgrade_CompressionOffered_IsNotNegotiated()
    {
        using var raw = await RawWebSocket.ConnectAsync(_gateway);

        var head = await raw.RequestAsync(
            "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n"
            + "Sec-WebSocket-Extensions: permessage-deflate; client_max_window_bits\r\n");

        Assert.That(head, Does.StartWith("HTTP/1.1 101 "));
        Assert.That(head, Does.Not.Contain("Sec-WebSocket-Extensions").IgnoreCase);
    }

    async Task<IAutobahnSubject> OpenAsync(string kind)
    {
        if (kind != Subjects[0]) return await LinkSubject.OpenAsync(kind == Subjects[1] ? null : _certificate);
        // As long as the connection of an earlier case is open, it is the source of the robot description, and the gateway rejects another source.
        await Soon.BecomesAsync(() => _gateway.WebSocketConnections.Open == 0, "the connection of the case before has ended");
        return await GatewaySubject.OpenAsync(_gateway);
    }

    static async Task WatchAsync(IAutobahnSubject subject, CaseScript script, ConcurrentQueue<string> seen)
    {
        await foreach (var (opcode, payload) in subject.Peer.Frames.ReadAllAsync())
            if (EventOf(subject, script, opcode, payload) is { } one) seen.Enqueue(one);
    }

    static string EventOf(IAutobahnSubject subject, CaseScript script, int opcode, byte[] payload) => opcode switch
    {
        CaseScript.Text => subject.EventOf(Encoding.UTF8.GetString(payload), script),
        CaseScript.Pong when script.PingPayloads.Contains(Encoding.UTF8.GetString(payload)) => "pong",
        // Ignores pings and empty pongs, which the system under test sends to keep the connection alive.
        CaseScript.Ping => null,
        CaseScript.Pong => payload.Length == 0 ? null : "garbled pong",
        CaseScript.CloseFrame => payload.Length < 2 ? "close" : "close:" + BinaryPrimitives.ReadUInt16BigEndian(payload),
        _ => "opcode " + opcode,
    };

    static string Sorted(string events) => string.Join(' ', events.Split(' ', StringSplitOptions.RemoveEmptyEntries).Order());
}
