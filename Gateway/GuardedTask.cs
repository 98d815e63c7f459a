namespace Nowpose.Gateway;

/// <summary>A task that a timer runs: never twice at a time, and an exception goes to the log.</summary>
/// <param name="failure">What could not be done, for the log.</param>
sealed class GuardedTask(Action task, string failure, Action<string> log)
{
    readonly Lock _lock = new();

    /// <summary>Runs the task, unless it runs already.</summary>
    public void RunUnlessBusy()
    {
        if (!_lock.TryEnter()) return;
        try
        {
            task();
        }
        catch (Exception e)
        {
            // All of them: an exception that leaves a timer's thread ends the process.
            log($"{failure} ({e.GetType().Name}: {e.Message})");
        }
        finally
        {
            _lock.Exit();
        }
    }

    /// <summary>Does something while the task does not run; waits for its end.</summary>
    public void Exclude(Action action)
    {
        lock (_lock) action();
    }
}
