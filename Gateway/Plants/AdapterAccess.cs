using System.Net;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Plants;

/// <summary>How a program that this gateway starts reaches it: told by its environment, which neither a file nor a list of processes shows.</summary>
/// <param name="WebSocket">On this machine.</param>
/// <param name="Token">Of a source, made at each start of the gateway.</param>
/// <param name="Pin">Of the gateway's key; null without TLS.</param>
sealed record AdapterAccess(Uri WebSocket, string Token, CertificatePin Pin)
{
    public static AdapterAccess To(GatewayServer gateway)
    {
        var bind = gateway.WebSocketEndPoint.Address;
        var host = bind.Equals(IPAddress.Any) ? IPAddress.Loopback : bind.Equals(IPAddress.IPv6Any) ? IPAddress.IPv6Loopback : bind;
        var scheme = gateway.Pin == null ? "ws" : "wss";
        return new AdapterAccess(
            new Uri($"{scheme}://{new IPEndPoint(host, gateway.WebSocketEndPoint.Port)}/"), gateway.AdapterToken, gateway.Pin);
    }

    public void Tell(IDictionary<string, string> environment)
    {
        environment["NOWPOSE_GATEWAY"] = WebSocket.ToString();
        environment["NOWPOSE_TOKEN"] = Token;
        if (Pin == null) environment.Remove("NOWPOSE_PIN");
        else environment["NOWPOSE_PIN"] = Pin.ToString();
    }

    /// <summary>Without the token.</summary>
    public override string ToString() => WebSocket.ToString();
}
