using Microsoft.AspNetCore.Http.Features;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Wraps Kestrel's own upgrade so that the WebSocket's received bytes are counted.</summary>
sealed class CountingUpgrade(IHttpUpgradeFeature inner) : IHttpUpgradeFeature
{
    Stream _stream;
    Func<ReadOnlyMemory<byte>, Task> _ping;

    public FragmentCounter Fragments { get; } = new();

    /// <summary>Called when something was received.</summary>
    public Action Received { get; set; }

    public bool IsUpgradableRequest => inner.IsUpgradableRequest;

    public async Task<Stream> UpgradeAsync()
    {
        _stream = await inner.UpgradeAsync();
        var counting = new CountingStream(_stream, Fragments, () => Received?.Invoke());
        _ping = counting.PingAsync;
        return counting;
    }

    /// <summary>Sends a ping once the WebSocket has been accepted.</summary>
    public Task PingAsync(ReadOnlyMemory<byte> payload) => _ping(payload);

    /// <summary>Reads and discards what a peer still sends after the close, until it disconnects or the time is up.</summary>
    /// <remarks>Closing with unread bytes would reset the connection, and the reason of the close would be lost.</remarks>
    public async Task DrainAsync(TimeSpan atMost)
    {
        using var timeUp = new CancellationTokenSource(atMost);
        try
        {
            await _stream.CopyToAsync(Stream.Null, timeUp.Token);
        }
        catch (Exception e) when (e is IOException or OperationCanceledException or ObjectDisposedException)
        {
            // The peer disconnected without a close, or the time is up.
        }
    }
}
