namespace Nowpose.Headless.Tests;

/// <summary>A frame's synchronisation context that no frame ever pumps: what is posted there waits for ever.</summary>
sealed class FrameContext : SynchronizationContext
{
    int _posts;

    public int Posts => Volatile.Read(ref _posts);

    public override void Post(SendOrPostCallback d, object state) => Interlocked.Increment(ref _posts);

    /// <summary>Runs on a thread that has this context, as Unity's main thread has its own.</summary>
    public T Run<T>(Func<T> make)
    {
        T made = default;
        var thread = new Thread(() =>
        {
            SetSynchronizationContext(this);
            made = make();
        });
        thread.Start();
        thread.Join();
        return made;
    }
}
