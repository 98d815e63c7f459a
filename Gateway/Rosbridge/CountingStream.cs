namespace Nowpose.Gateway.Rosbridge;

/// <summary>The stream under a WebSocket. Passes received bytes to a <see cref="FragmentCounter"/>, and sends pings between frames.</summary>
/// <remarks>The WebSocket writes each frame with one call, so a ping cannot interrupt a frame.</remarks>
sealed class CountingStream(Stream inner, FragmentCounter counter) : Stream
{
    const byte FinalPing = 0x89;

    readonly SemaphoreSlim _writing = new(1);

    public override bool CanRead => true;
    public override bool CanSeek => false;
    public override bool CanWrite => true;
    public override long Length => throw new NotSupportedException();
    public override long Position { get => throw new NotSupportedException(); set => throw new NotSupportedException(); }

    /// <summary>Sends a ping.</summary>
    /// <param name="payload">The payload, at most 125 bytes.</param>
    public async Task PingAsync(ReadOnlyMemory<byte> payload)
    {
        byte[] frame = [FinalPing, (byte)payload.Length, .. payload.Span];
        await WriteAsync(frame);
    }

    public override async ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellationToken = default)
    {
        var read = await inner.ReadAsync(buffer, cancellationToken);
        counter.Feed(buffer.Span[..read]);
        return read;
    }

    public override Task<int> ReadAsync(byte[] buffer, int offset, int count, CancellationToken cancellationToken) =>
        ReadAsync(buffer.AsMemory(offset, count), cancellationToken).AsTask();

    public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    public override async ValueTask WriteAsync(ReadOnlyMemory<byte> buffer, CancellationToken cancellationToken = default)
    {
        await _writing.WaitAsync(cancellationToken);
        try
        {
            await inner.WriteAsync(buffer, cancellationToken);
        }
        finally
        {
            _writing.Release();
        }
    }

    public override Task WriteAsync(byte[] buffer, int offset, int count, CancellationToken cancellationToken) =>
        WriteAsync(buffer.AsMemory(offset, count), cancellationToken).AsTask();

    public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    // Does nothing, because Kestrel sends the bytes of each write at once.
    public override Task FlushAsync(CancellationToken cancellationToken) => Task.CompletedTask;

    public override void Flush() => throw new NotSupportedException();
    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();
    public override void SetLength(long value) => throw new NotSupportedException();

    // Does not dispose the semaphore, because a ping may still be waiting for it.
    protected override void Dispose(bool disposing)
    {
        if (disposing)
            inner.Dispose();
        base.Dispose(disposing);
    }
}
