using System.Security.Cryptography.X509Certificates;
using Nowpose.Headless.Tests.Network;
using Nowpose.Network;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>
/// A headset's link as the system under test. A message counts as accepted if the link returns it and it conforms to the protocol.
/// </summary>
sealed class LinkSubject : IAutobahnSubject
{
    readonly FakeWebSocketServer _server = new();
    readonly CancellationTokenSource _stop = new();
    readonly RosbridgeReader _reader = new();
    IWebSocketLink _link;
    Task _receiving = Task.CompletedTask;
    CaseScript _script;

    public FramedPeer Peer { get; private set; }

    public Action<string> Saw { get; set; }

    /// <param name="certificate">
    /// Certificate for wss with a pin; null for ws.
    /// </param>
    public static async Task<IAutobahnSubject> OpenAsync(X509Certificate2 certificate)
    {
        var subject = new LinkSubject();
        var pin = certificate == null ? null : CertificatePin.Of(certificate);
        var settings = new ConnectionSettings("127.0.0.1", webSocketPort: subject._server.Port, pin: pin);
        subject._link = WebSocketLinks.Create(settings, new StopwatchHeadsetClock());
        var opening = subject._link.OpenAsync(CancellationToken.None);
        var stream = await subject._server.AcceptStreamAsync(certificate);
        // The server must close the TCP connection first, because .NET's client waits for it.
        subject.Peer = new FramedPeer(stream, isMasked: false, stream.Dispose);
        await opening.Bounded();
        return subject;
    }

    public CaseScript NewScript()
    {
        _script = new CaseScript(
            false, """{"op":"publish","topic":"/joint_states","msg":{"header":{"stamp":{"sec":5,"nanosec":0}},"position":[1],"name":["x""", "\"]}}");
        _receiving = Task.Run(ReceiveAsync);
        return _script;
    }

    public string EventOf(string text, CaseScript script) => null;

    public async ValueTask DisposeAsync()
    {
        await _stop.CancelAsync();
        _link.Dispose();
        await _receiving.Bounded();
        _server.Dispose();
        _stop.Dispose();
    }

    // Receives until the connection ends, and then disposes the link, as RosbridgeClient does.
    async Task ReceiveAsync()
    {
        try
        {
            await _link.ReceiveAsync(received =>
            {
                if (EventOf(received) is { } one) Saw(one);
            }, _stop.Token);
        }
        catch (Exception)
        {
            // Any exception ends the link.
        }
        _link.Dispose();
    }

    string EventOf(in ReceivedText received)
    {
        if (received.Dropped != DropReason.None || !_reader.TryRead(received.Utf8.Span, out var message, out _)) return "refused";
        if (message.Data != null) return null;
        return _script.Inner.Contains(message.JointState.Names[0][1..]) ? "accepted" : "garbled: " + message.JointState.Names[0];
    }
}
