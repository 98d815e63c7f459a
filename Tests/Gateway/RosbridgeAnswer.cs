using System.Net;
using Nowpose.Network;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Connects to the WebSocket port of a gateway like a headset, and returns the HTTP status of the response.</summary>
static class RosbridgeAnswer
{
    public static async Task<HttpStatusCode> RosbridgeStatusAsync(PairingGateway gateway, string token)
    {
        using var link = WebSocketLinks.Create(gateway.CellCode().ToConnection(token, "headset 7"), new StopwatchHeadsetClock());
        try
        {
            await link.OpenAsync(CancellationToken.None).Bounded();
            return HttpStatusCode.SwitchingProtocols;
        }
        catch (GatewayRefusalException refused) when (refused.IsOfToken)
        {
            return HttpStatusCode.Unauthorized;
        }
    }
}
