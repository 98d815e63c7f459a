using System.Collections.Concurrent;
using System.Net.WebSockets;
using System.Text.Json;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>Receives the diagnostics of adapters and headsets from the gateway, like any rosbridge client, and keeps the newest.</summary>
sealed class HeardDiagnostics : IDisposable
{
    readonly RawRosbridgeClient _client;
    readonly ConcurrentDictionary<string, JsonElement> _newest = [];

    HeardDiagnostics(RawRosbridgeClient client)
    {
        _client = client;
        _ = ListenAsync();
    }

    public static async Task<HeardDiagnostics> StartAsync(Uri gateway)
    {
        var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync("/nowpose/diagnostics");
        return new HeardDiagnostics(client);
    }

    /// <summary>Returns the newest DiagnosticStatus with this id; null before the first.</summary>
    public JsonElement? NewestOf(string hardwareId) => _newest.TryGetValue(hardwareId, out var status) ? status : null;

    /// <summary>Removes the newest status with this id. Called before another headset of the same name connects.</summary>
    public void Forget(string hardwareId) => _newest.TryRemove(hardwareId, out _);

    public void Dispose() => _client.Dispose();

    async Task ListenAsync()
    {
        try
        {
            while (true)
            {
                using var message = JsonDocument.Parse(await _client.ReceiveTextAsync());
                var status = message.RootElement.GetProperty("msg").GetProperty("status")[0].Clone();
                _newest[status.GetProperty("hardware_id").GetString()] = status;
            }
        }
        catch (Exception e) when (e is WebSocketException or OperationCanceledException or ObjectDisposedException)
        {
            // Dispose has closed the client.
        }
    }
}
