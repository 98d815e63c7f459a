using Nowpose.Gateway;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>
/// The gateway as the system under test. A message counts as accepted if the response to its service call arrives with the same id.
/// </summary>
sealed class GatewaySubject : IAutobahnSubject
{
    readonly Gateway.RawWebSocket _raw;

    GatewaySubject(Gateway.RawWebSocket raw)
    {
        _raw = raw;
        Peer = new FramedPeer(raw.Stream, isMasked: true, raw.EndSending);
    }

    public FramedPeer Peer { get; }

    public Action<string> Saw { set { } }

    public static async Task<IAutobahnSubject> OpenAsync(GatewayServer gateway) => new GatewaySubject(await Gateway.RawWebSocket.OpenAsync(gateway));

    public CaseScript NewScript() => new(true, "{\"op\":\"call_service\",\"service\":\"/rosapi/get_time\",\"id\":\"", "\"}");

    public string EventOf(string text, CaseScript script)
    {
        if (!RosbridgeReader.TryRead(text, out var message, out var reason)) return "garbled: " + reason;
        if (message.Op == RosbridgeOp.Status) return "refused";
        return script.Inner.Contains(message.Id.ToString()) ? "accepted" : "garbled: " + message.Id;
    }

    public ValueTask DisposeAsync()
    {
        _raw.Dispose();
        return ValueTask.CompletedTask;
    }
}
