using System.Buffers.Binary;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Follows by pings how far a client has read, and says when more may be sent to it. Any thread.</summary>
/// <param name="sendPing">Sends a ping with a payload after everything that was sent before.</param>
sealed class ReaderProgress(Func<ReadOnlyMemory<byte>, Task> sendPing, TimeSpan pingInterval, TimeSpan pongTimeout, TimeProvider time)
{
    const int PayloadBytes = sizeof(long);

    /// <summary>A client that reads more slowly than this may be closed while a long message is on its way to it.</summary>
    const double MinBytesPerSecond = 3000;

    static readonly TimeSpan MaxTick = TimeSpan.FromMilliseconds(250);

    readonly Lock _lock = new();
    readonly SendWindow _window = new();
    readonly long _start = time.GetTimestamp();
    TaskCompletionSource _changed = NewSignal();
    TimeSpan _lastPing;
    TimeSpan _lastReceived;

    TimeSpan Now => time.GetElapsedTime(_start);

    /// <summary>How long a client may take to read some bytes, and to answer.</summary>
    public TimeSpan Patience(long bytes) => pongTimeout + TimeSpan.FromSeconds(bytes / MinBytesPerSecond);

    /// <summary>Until when messages had to wait for the client the last time, a count of the time provider.</summary>
    public long WaitedUntil { get; private set; } = long.MinValue;

    /// <summary>Completes when a message may be sent.</summary>
    public async Task OpensAsync(CancellationToken stop)
    {
        while (NextChange() is { } change)
        {
            await change.WaitAsync(stop);
            OnWaited();
        }
    }

    /// <summary>Notes that a message had to wait for the client. By one thread at a time, as <see cref="OpensAsync"/>.</summary>
    public void OnWaited() => WaitedUntil = time.GetTimestamp();

    /// <summary>To be called before a message is sent.</summary>
    public Task SendsAsync(int bytes)
    {
        lock (_lock)
            if (!_window.IsPingDueBefore(bytes)) return Task.CompletedTask;
        return PingAsync();
    }

    /// <summary>To be called after a message was sent.</summary>
    public Task SentAsync(int bytes)
    {
        lock (_lock)
        {
            _window.OnSent(bytes);
            if (!_window.IsPingDue) return Task.CompletedTask;
        }

        return PingAsync();
    }

    /// <summary>Notes that something came from the client.</summary>
    public void OnReceived()
    {
        lock (_lock) _lastReceived = Now;
    }

    /// <summary>Takes the payload of a pong; those that answer no ping of this class are ignored.</summary>
    public void OnPong(ReadOnlySpan<byte> payload)
    {
        if (payload.Length != PayloadBytes) return;
        bool isPingDue;
        lock (_lock)
        {
            _window.OnPong(BinaryPrimitives.ReadInt64BigEndian(payload), Now);
            isPingDue = _window.IsPingDue;
        }

        Signal();
        if (isPingDue) _ = PingAsync();
    }

    /// <summary>Sends a ping each interval until the client does not answer in time.</summary>
    /// <exception cref="OperationCanceledException">Stopped.</exception>
    public async Task BecomesSilentAsync(CancellationToken stop)
    {
        var shortest = pingInterval < pongTimeout ? pingInterval : pongTimeout;
        using var timer = new PeriodicTimer(shortest / 4 < MaxTick ? shortest / 4 : MaxTick, time);
        while (await timer.WaitForNextTickAsync(stop))
        {
            if (IsSilent()) return;
            bool isPingDue;
            lock (_lock) isPingDue = _window.PingAt == null && Now - _lastPing >= pingInterval;
            // Time passes for a window, too: it opens for a client that answers no pings.
            Signal();
            if (isPingDue) _ = PingAsync();
        }
    }

    /// <summary>Whether the client has not answered a ping in time.</summary>
    internal bool IsSilent()
    {
        lock (_lock)
        {
            if (_window.PingAt is not { } pingAt) return false;
            // What a client sends counts as long as it never answered a ping. One that did, and does not any more, has stopped reading.
            var last = _window.HasAnswered || _lastReceived < pingAt ? pingAt : _lastReceived;
            // Bytes behind the ping delay no pong.
            return Now - last >= Patience(_window.BytesBeforePing);
        }
    }

    async Task PingAsync()
    {
        var payload = new byte[PayloadBytes];
        lock (_lock)
        {
            if (_window.PingAt != null) return;
            _lastPing = Now;
            BinaryPrimitives.WriteInt64BigEndian(payload, _window.OnPing(_lastPing));
        }

        try
        {
            await sendPing(payload);
        }
        catch (Exception e) when (e is IOException or ObjectDisposedException or InvalidOperationException or OperationCanceledException)
        {
            // The connection ends, which the receiving side notices.
        }
    }

    // Null while the window is open.
    Task NextChange()
    {
        lock (_lock) return _window.IsOpen(Now) ? null : _changed.Task;
    }

    void Signal()
    {
        TaskCompletionSource changed;
        lock (_lock) (changed, _changed) = (_changed, NewSignal());
        changed.TrySetResult();
    }

    static TaskCompletionSource NewSignal() => new(TaskCreationOptions.RunContinuationsAsynchronously);
}
