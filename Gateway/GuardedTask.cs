namespace Nowpose.Gateway;

/// <summary>Runs a task for a timer, never twice at the same time, and logs its exceptions.</summary>
/// <param name="failure">Log text that precedes the exception.</param>
sealed class GuardedTask(Action task, string failure, Action<string> log)
{
    readonly Lock _lock = new();

    /// <summary>Runs the task, unless it is still running from an earlier call.</summary>
    public void RunUnlessBusy()
    {
        if (!_lock.TryEnter()) return;
        try
        {
            task();
        }
        catch (Exception e)
        {
            // Catches all exceptions, because an unhandled exception on a timer's thread ends the process.
            log($"{failure} ({e.GetType().Name}: {e.Message})");
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
}
