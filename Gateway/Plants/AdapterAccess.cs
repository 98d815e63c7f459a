using System.Net;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Plants;

/// <summary>Access to this gateway for a program that it starts. Passed in the environment, which files and process lists do not show.</summary>
/// <param name="WebSocket">Address of the WebSocket on this machine.</param>
/// <param name="Token">Token with the role of a source, created at each start of the gateway.</param>
/// <param name="Pin">Pin of the gateway's key; null without TLS.</param>
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

    /// <summary>Gets the address, without the token.</summary>
    public override string ToString() => WebSocket.ToString();
}
