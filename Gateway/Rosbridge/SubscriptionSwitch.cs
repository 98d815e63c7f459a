namespace Nowpose.Gateway.Rosbridge;

/// <summary>Switches between a client's successive subscriptions to one topic: sends the messages of one subscription after the other.</summary>
/// <remarks>
/// If a client that does not read changes its subscription repeatedly, the first subscription stays active, the newest one waits, and those
/// in between are skipped. Thus the number of subscriptions is bounded.
/// </remarks>
/// <param name="pump">Sends the messages of a subscription until its end.</param>
sealed class SubscriptionSwitch(Func<Subscription, Task> pump)
{
    readonly Lock _lock = new();
    Subscription _next;
    bool _isRunning;

    /// <summary>Completes when all started subscriptions have ended.</summary>
    public Task Ended { get; private set; } = Task.CompletedTask;

    /// <summary>Starts to send the messages of a subscription as soon as the previous subscription has ended. Not thread-safe.</summary>
    public void Start(Subscription subscription)
    {
        lock (_lock)
        {
            _next?.CountUnsent();
            _next = subscription;
            if (_isRunning) return;
            _isRunning = true;
        }

        Ended = RunAsync();
    }

    async Task RunAsync()
    {
        while (Take() is { } subscription)
            await pump(subscription);
    }

    Subscription Take()
    {
        lock (_lock)
        {
            var next = _next;
            _next = null;
            _isRunning = next != null;
            return next;
        }
    }
}
