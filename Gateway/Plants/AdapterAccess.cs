using System.Net;

namespace Nowpose.Gateway.Plants;

/// <summary>The address, token and pin with which an adapter program connects to the gateway that started it.</summary>
/// <remarks>They are passed in environment variables, because command lines are visible to other users.</remarks>
/// <param name="WebSocket">Address of the WebSocket on this machine.</param>
/// <param name="Token">Token with the role of a source, created at each start of the gateway.</param>
/// <param name="Pin">Pin of the gateway's certificate; null without TLS.</param>
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

    public void AddTo(IDictionary<string, string> environment)
    {
        environment["NOWPOSE_GATEWAY"] = WebSocket.ToString();
        environment["NOWPOSE_TOKEN"] = Token;
        if (Pin == null) environment.Remove("NOWPOSE_PIN");
        else environment["NOWPOSE_PIN"] = Pin.ToString();
    }

    /// <summary>Returns the address only, so that the token does not appear in a log.</summary>
    public override string ToString() => WebSocket.ToString();
}
