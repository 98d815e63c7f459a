namespace Nowpose.Headless.Tests;

/// <summary>Synchronisation context of a frame loop that is stopped. Work that is posted to it never runs.</summary>
sealed class FrameContext : SynchronizationContext
{
    int _posts;

    public int Posts => Volatile.Read(ref _posts);

    public override void Post(SendOrPostCallback d, object state) => Interlocked.Increment(ref _posts);

    /// <summary>Runs a function on a thread that has this context, like Unity's main thread.</summary>
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
