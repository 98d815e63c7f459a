namespace Nowpose.Gateway.Status;

/// <summary>
/// Computes a result for several requests together, so that many clients do not keep the processor busy. Requests that arrive during a computation
/// share the next one, so that no result is older than its request. Thread-safe.
/// </summary>
sealed class SharedResult<T>(Func<T> compute)
{
    readonly Lock _lock = new();
    Task _running = Task.CompletedTask;
    Task<T> _next;

    public Task<T> GetAsync()
    {
        lock (_lock)
            return _next ??= _running.ContinueWith(_ => Compute(), CancellationToken.None, TaskContinuationOptions.None, TaskScheduler.Default);
    }

    T Compute()
    {
        lock (_lock) (_running, _next) = (_next, null);
        return compute();
    }
}
