namespace Nowpose.Gateway;

/// <summary>Runs a task periodically, never twice at the same time, and logs its exceptions.</summary>
/// <param name="failure">Returns the log line about an exception, from its type and message.</param>
sealed class PeriodicTask(Action task, TimeSpan interval, Func<string, string> failure, Action<string> log, TimeProvider time) : IDisposable
{
    readonly Lock _lock = new();
    ITimer _timer;
    volatile bool _isDisposed;

    /// <summary>Runs the task after each interval.</summary>
    public void Start() => _timer = time.CreateTimer(_ => RunUnlessBusy(), null, interval, interval);

    /// <summary>Runs the task, unless it is still running from an earlier call.</summary>
    public void RunUnlessBusy()
    {
        if (!_lock.TryEnter()) return;
        try
        {
            if (!_isDisposed) task();
        }
        catch (Exception e)
        {
            // Catches all exceptions, because an unhandled exception on a timer's thread ends the process.
            log(failure($"{e.GetType().Name}: {e.Message}"));
        }
        finally
        {
            _lock.Exit();
        }
    }

    /// <summary>Waits until the task is not running, and runs an action before the task can start again.</summary>
    public void Exclude(Action action)
    {
        lock (_lock) action();
    }

    /// <summary>Prevents further runs. Does not wait for the present one, which may be waiting for the disk.</summary>
    public void Dispose()
    {
        _isDisposed = true;
        _timer?.Dispose();
    }
}
