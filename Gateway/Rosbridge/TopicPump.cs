namespace Nowpose.Gateway.Rosbridge;

/// <summary>Sends what a client's subscriptions to one topic get, one after the other in their order.</summary>
/// <remarks>
/// A client that reads nothing may change its wishes as often as it likes: one subscription is being sent, one waits, and those
/// between were never begun.
/// </remarks>
/// <param name="pump">Sends what a subscription gets, to its end.</param>
sealed class TopicPump(Func<Subscription, Task> pump)
{
    readonly Lock _lock = new();
    Subscription _next;
    bool _isRunning;

    /// <summary>Completes when all that were started have ended.</summary>
    public Task Ended { get; private set; } = Task.CompletedTask;

    /// <summary>Sends what the subscription gets as soon as the one before has ended. From one thread at a time.</summary>
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
