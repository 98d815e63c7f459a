using System.Net;
using System.Net.Http.Headers;
using System.Text.Json;
using Nowpose.Gateway;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>Sends requests to the routes that monitoring reads.</summary>
static class StatusRequests
{
    public static async Task<(HttpStatusCode Status, string Text, HttpContentHeaders Headers)> GetAsync(
        GatewayServer gateway, string path, string token = null, string host = null, HttpMethod method = null, string origin = null)
    {
        using var http = new HttpClient();
        using var request = new HttpRequestMessage(method ?? HttpMethod.Get, new Uri($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}{path}"));
        if (token != null) request.Headers.Authorization = new AuthenticationHeaderValue("Bearer", token);
        if (host != null) request.Headers.Host = host;
        if (origin != null) request.Headers.Add("Origin", origin);
        using var response = await http.SendAsync(request).Bounded();
        return (response.StatusCode, await response.Content.ReadAsStringAsync().Bounded(), response.Content.Headers);
    }

    public static async Task<JsonElement> StateAsync(GatewayServer gateway) =>
        JsonDocument.Parse((await GetAsync(gateway, "/operations/state")).Text).RootElement;
}
