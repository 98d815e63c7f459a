using Microsoft.AspNetCore.Http.Features;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Wraps Kestrel's upgrade to a WebSocket, so that the WebSocket uses a <see cref="CountingStream"/>.</summary>
sealed class CountingUpgrade(IHttpUpgradeFeature inner) : IHttpUpgradeFeature
{
    Stream _stream;
    Func<ReadOnlyMemory<byte>, Task> _ping;

    public FragmentCounter Fragments { get; } = new();

    public bool IsUpgradableRequest => inner.IsUpgradableRequest;

    public async Task<Stream> UpgradeAsync()
    {
        _stream = await inner.UpgradeAsync();
        var counting = new CountingStream(_stream, Fragments);
        _ping = counting.PingAsync;
        return counting;
    }

    /// <summary>Sends a ping. Call it only after the WebSocket has been accepted.</summary>
    public Task PingAsync(ReadOnlyMemory<byte> payload) => _ping(payload);

    /// <summary>Reads and discards the bytes that a client sends after the close frame, until it disconnects or the time is up.</summary>
    /// <remarks>Closing a socket with unread bytes resets the connection, and the client would not receive the reason for the closure.</remarks>
    /// <param name="atMost">Maximum time.</param>
    public async Task DrainAsync(TimeSpan atMost)
    {
        using var timeUp = new CancellationTokenSource(atMost);
        try
        {
            await _stream.CopyToAsync(Stream.Null, timeUp.Token);
        }
        catch (Exception e) when (e is IOException or OperationCanceledException or ObjectDisposedException)
        {
            // The client disconnected without a close frame, or the time is up.
        }
    }
}
