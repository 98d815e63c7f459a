using System.Net;
using Nowpose.Network;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>The answer of a gateway to a headset that connects to its WebSocket port.</summary>
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
