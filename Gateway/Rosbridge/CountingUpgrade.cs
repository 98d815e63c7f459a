using Microsoft.AspNetCore.Http.Features;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Stands before Kestrel's own upgrade so that the WebSocket's bytes are counted on their way in.</summary>
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

    /// <summary>Sends a ping of the WebSocket, once it was accepted.</summary>
    public Task PingAsync(ReadOnlyMemory<byte> payload) => _ping(payload);

    /// <summary>Reads past what a peer still sends that was told why its WebSocket ends, until it goes or the time is up.</summary>
    /// <remarks>Closing with bytes unread would reset the connection, and what was told be lost.</remarks>
    public async Task DrainAsync(TimeSpan atMost)
    {
        using var timeUp = new CancellationTokenSource(atMost);
        try
        {
            await _stream.CopyToAsync(Stream.Null, timeUp.Token);
        }
        catch (Exception e) when (e is IOException or OperationCanceledException or ObjectDisposedException)
        {
            // Gone without a goodbye, or not going.
        }
    }
}
