using System.Text;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Disturbances;

/// <summary>A client with a network of limited speed, on which one message is under way at a time.</summary>
sealed class DisturbedClient
{
    readonly DisturbedGateway _gateway;
    readonly Action<string> _read;
    readonly Dictionary<string, SubscriptionSwitch> _switches = [];
    readonly Queue<TaskCompletionSource> _waiting = [];
    readonly CancellationTokenSource _stop = new();
    readonly RosbridgeSession _session;
    TaskCompletionSource _changed = new();
    double _bytesPerSecond = double.PositiveInfinity, _busyUntil;
    long _waitedUntil = long.MinValue;
    bool _isSending;

    /// <param name="read">Called with each message of a subscription that is sent to the client.</param>
    public DisturbedClient(DisturbedGateway gateway, Role role, Action<string> read)
    {
        (_gateway, _read, Address) = (gateway, read, gateway.NextAddress());
        _session = gateway.Connect(role, Address, _ => { }, Start);
    }

    public string Address { get; }
    public bool IsOpen { get; private set; } = true;

    /// <summary>First exception of a subscription; null if there was none.</summary>
    public Exception Failure { get; private set; }

    bool IsBusy => _bytesPerSecond == 0 || _busyUntil > _gateway.Loop.Seconds;

    /// <summary>Sets the number of bytes that the client reads per second; 0 if it does not read.</summary>
    public void Read(double bytesPerSecond)
    {
        _bytesPerSecond = bytesPerSecond;
        if (bytesPerSecond == double.PositiveInfinity) _busyUntil = 0;
        var changed = _changed;
        _changed = new TaskCompletionSource();
        changed.SetResult();
    }

    public void Send(string text) => Send(Encoding.UTF8.GetBytes(text), DropReason.None);

    /// <param name="fault">Fault of the message, found before its content is read.</param>
    public void Send(byte[] utf8, DropReason fault)
    {
        if (!IsOpen) return;
        _session.Handle(new Received(utf8, fault, null, _gateway.Loop.Time.GetTimestamp()));
        // The hub parses descriptions on another thread.
        _gateway.Hub.Links.Read.Wait();
    }

    /// <param name="isClean">Whether the client closes the connection; false if the gateway ends it, or notices that it is lost.</param>
    public void Close(bool isClean)
    {
        if (!IsOpen) return;
        IsOpen = false;
        if (isClean) _session.Leave();
        _session.Dispose();
        _stop.Cancel();
    }

    void Start(Subscription subscription)
    {
        if (!_switches.TryGetValue(subscription.Topic, out var own)) _switches.Add(subscription.Topic, own = new SubscriptionSwitch(PumpAsync));
        own.Start(subscription);
    }

    async Task PumpAsync(Subscription subscription)
    {
        try
        {
            await subscription.PumpAsync(SendAsync, _stop.Token);
        }
        catch (OperationCanceledException)
        {
            // The connection has ended.
        }
        catch (Exception e)
        {
            Failure ??= e;
        }
    }

    async Task SendAsync(Func<long, ReadOnlyMemory<byte>> next)
    {
        await EnterAsync();
        try
        {
            await BecomesFreeAsync();
            var message = next(_waitedUntil);
            if (message.IsEmpty) return;
            _busyUntil = _gateway.Loop.Seconds + message.Length / _bytesPerSecond;
            _read(Encoding.UTF8.GetString(message.Span));
        }
        finally
        {
            if (_waiting.TryDequeue(out var other)) other.SetResult();
            else _isSending = false;
        }
    }

    // Unlike a semaphore, continues on the thread of the loop.
    Task EnterAsync()
    {
        if (_isSending)
        {
            var turn = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
            _waiting.Enqueue(turn);
            return turn.Task;
        }

        _isSending = true;
        return Task.CompletedTask;
    }

    // Waits until the client has read the message before.
    async Task BecomesFreeAsync()
    {
        while (!_stop.IsCancellationRequested && IsBusy)
        {
            var wait = _bytesPerSecond == 0
                ? Timeout.InfiniteTimeSpan : TimeSpan.FromMilliseconds(Math.Ceiling(1000 * (_busyUntil - _gateway.Loop.Seconds)));
            await Task.WhenAny(Task.Delay(wait, _gateway.Loop.Time, _stop.Token), _changed.Task);
            _waitedUntil = _gateway.Loop.Time.GetTimestamp();
        }

        _stop.Token.ThrowIfCancellationRequested();
    }
}
