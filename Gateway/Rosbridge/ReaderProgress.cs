using System.Buffers.Binary;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Measures with pings how much a client has read, and limits the amount of unread data. Thread-safe.</summary>
sealed class ReaderProgress : IDisposable
{
    const int PayloadBytes = sizeof(long);

    /// <summary>Delay of a ping after the message that makes it due.</summary>
    /// <remarks>
    /// A sample is sent to all clients at the same time. Immediate pings and their pongs would delay the sample for the last clients.
    /// </remarks>
    internal static readonly TimeSpan PingDelay = TimeSpan.FromMilliseconds(5);

    /// <summary>
    /// Delay of a ping to a near client, whose window allows a longer delay. Sending a sample to 200 clients may take more than 5 ms.
    /// </summary>
    internal static readonly TimeSpan NearPingDelay = TimeSpan.FromMilliseconds(11);

    /// <summary>
    /// Interval at which the window is checked while a message waits. The window of a client that does not answer pings opens over time.
    /// </summary>
    static readonly TimeSpan WaitStep = TimeSpan.FromMilliseconds(250);

    readonly Func<ReadOnlyMemory<byte>, Task> _sendPing;
    readonly TimeSpan _pingInterval;
    readonly TimeSpan _pongTimeout;
    readonly TimeProvider _time;
    readonly Lock _lock = new();
    readonly SendWindow _window = new();
    readonly long _start;
    readonly ITimer _delayedPing;
    readonly Action _unanswered;
    // Payload of the newest ping. At most one is outstanding at a time; it is repeated at the ping interval.
    readonly byte[] _payload = new byte[PayloadBytes];
    bool _isPingPlanned;
    bool _isUnansweredReported;
    // Completed when the window may have opened; null while no message waits.
    TaskCompletionSource _changed;
    TimeSpan _lastPing;

    /// <param name="sendPing">Sends a ping with a payload, after all data sent before.</param>
    /// <param name="unanswered">
    /// Called once, when the messages to a client that does not answer pings are limited to an assumed read rate; null if no call is needed.
    /// </param>
    public ReaderProgress(
        Func<ReadOnlyMemory<byte>, Task> sendPing, TimeSpan pingInterval, TimeSpan pongTimeout, TimeProvider time, Action unanswered = null)
    {
        _unanswered = unanswered ?? (() => { });
        _sendPing = sendPing;
        _pingInterval = pingInterval;
        _pongTimeout = pongTimeout;
        _time = time;
        _start = time.GetTimestamp();
        _delayedPing = time.CreateTimer(_ => _ = PingAsync(), null, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
    }

    TimeSpan Now => _time.GetElapsedTime(_start);

    public TimeProvider Time => _time;

    /// <summary>Timeout within which the client must answer a ping, and within which a part of a message must be sent.</summary>
    public TimeSpan PongTimeout => _pongTimeout;

    /// <summary>Time at which the last wait of a message for the client ended, a timestamp of the time provider.</summary>
    public long WaitedUntil { get; private set; } = long.MinValue;

    /// <summary>Waits until a message may be sent.</summary>
    /// <param name="isReply"><inheritdoc cref="SendWindow.IsOpen" path="/param[@name='isReply']"/></param>
    public async Task OpensAsync(bool isReply, CancellationToken stop)
    {
        while (NextChange(isReply) is { } change)
        {
            await Task.WhenAny(change, Task.Delay(WaitStep, _time, stop));
            stop.ThrowIfCancellationRequested();
            OnWaited();
        }
    }

    /// <summary>Records that a message had to wait for the client. Not thread-safe, like <see cref="OpensAsync"/>.</summary>
    public void OnWaited() => WaitedUntil = _time.GetTimestamp();

    /// <summary>Sends a ping if one is due before a message. Call this method before each message.</summary>
    public Task SendsAsync(int bytes)
    {
        lock (_lock)
            if (!_window.IsPingDueBefore(bytes)) return Task.CompletedTask;
        return PingAsync();
    }

    /// <summary>Counts a message, or a part of one, that was sent. Call this method after each of them.</summary>
    /// <param name="bytes">Length of the message or part.</param>
    /// <param name="isReply"><inheritdoc cref="SendWindow.IsOpen" path="/param[@name='isReply']"/></param>
    /// <param name="isEnd"><inheritdoc cref="SendWindow.OnSent" path="/param[@name='isEnd']"/></param>
    public void OnSent(int bytes, bool isReply = false, bool isEnd = true)
    {
        lock (_lock)
        {
            _window.OnSent(bytes, Now, isReply, isEnd);
            PlanPing();
        }
    }

    /// <summary>Processes the payload of a pong. Ignores a pong that does not answer a ping of this object.</summary>
    public void OnPong(ReadOnlySpan<byte> payload)
    {
        if (payload.Length != PayloadBytes) return;
        lock (_lock)
        {
            _window.OnPong(BinaryPrimitives.ReadInt64BigEndian(payload), Now);
            PlanPing();
        }

        Signal();
    }

    /// <summary>Sends pings at the ping interval, until the client fails to answer in time or reads too slowly.</summary>
    /// <returns><see cref="Closure.Silence"/> or <see cref="Closure.SlowReader"/>.</returns>
    /// <exception cref="OperationCanceledException">The wait was cancelled.</exception>
    public async Task<Closure> WatchAsync(CancellationToken stop)
    {
        var shortest = _pingInterval < _pongTimeout ? _pingInterval : _pongTimeout;
        while (true)
        {
            await Task.Delay(shortest / 4, _time, stop);
            if (IsSilent()) return Closure.Silence;
            bool isPingDue;
            lock (_lock)
            {
                if (_window.IsTooSlow) return Closure.SlowReader;
                isPingDue = Now - _lastPing >= _pingInterval;
            }

            if (isPingDue) _ = PingAsync(isRepeated: true);
        }
    }

    /// <summary>Whether the client has not answered a ping in time.</summary>
    internal bool IsSilent()
    {
        lock (_lock)
        {
            return _window.PingAt is { } pingAt && Now - pingAt >= _pongTimeout;
        }
    }

    public void Dispose() => _delayedPing.Dispose();

    // Called under the lock.
    void PlanPing()
    {
        if (_isPingPlanned || !_window.IsPingDue) return;
        _isPingPlanned = true;
        _delayedPing.Change(_window.IsNear ? NearPingDelay : PingDelay, Timeout.InfiniteTimeSpan);
    }

    // A repeated ping has the payload of the outstanding one, so that the pong of either confirms the same bytes.
    async Task PingAsync(bool isRepeated = false)
    {
        lock (_lock)
        {
            if (!isRepeated) _isPingPlanned = false;
            if (_window.PingAt != null && !isRepeated) return;
            _lastPing = Now;
            if (_window.PingAt == null) BinaryPrimitives.WriteInt64BigEndian(_payload, _window.OnPing(_lastPing));
        }

        try
        {
            await _sendPing(_payload);
        }
        catch (Exception e) when (e is IOException or ObjectDisposedException or InvalidOperationException or OperationCanceledException)
        {
            // The connection has ended. The receiving loop detects this.
        }
    }

    // Returns a task that completes when the window may have opened; null while the window is open.
    Task NextChange(bool isReply)
    {
        Task change;
        bool isReportDue;
        lock (_lock)
        {
            change = _window.IsOpen(Now, isReply) ? null : (_changed ??= new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously)).Task;
            isReportDue = _window.IsAssumed && !_isUnansweredReported;
            _isUnansweredReported |= isReportDue;
        }

        if (isReportDue) _unanswered();
        return change;
    }

    void Signal()
    {
        TaskCompletionSource changed;
        lock (_lock) (changed, _changed) = (_changed, null);
        changed?.TrySetResult();
    }
}
