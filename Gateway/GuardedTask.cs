namespace Nowpose.Gateway;

/// <summary>A task that a timer runs. It never runs concurrently, and its exceptions are logged.</summary>
/// <param name="failure">Log text for a failure.</param>
sealed class GuardedTask(Action task, string failure, Action<string> log)
{
    readonly Lock _lock = new();

    /// <summary>Runs the task, unless it is running.</summary>
    public void RunUnlessBusy()
    {
        if (!_lock.TryEnter()) return;
        try
        {
            task();
        }
        catch (Exception e)
        {
            // Catches all exceptions: an unhandled one on a timer's thread ends the process.
            log($"{failure} ({e.GetType().Name}: {e.Message})");
        }
        finally
        {
            _lock.Exit();
        }
    }

    /// <summary>Waits until the task is not running, and runs an action before it can start again.</summary>
    public void Exclude(Action action)
    {
        lock (_lock) action();
    }
}
