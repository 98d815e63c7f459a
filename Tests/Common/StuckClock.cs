namespace Nowpose.Tests.Common;

/// <summary>Holds whoever asks for the time until it is let go: a thread that does not come to its end.</summary>
sealed class StuckClock : IHeadsetClock
{
    readonly TaskCompletionSource _asked = new(TaskCreationOptions.RunContinuationsAsynchronously);
    readonly ManualResetEventSlim _goOn = new();

    /// <summary>Completes when a thread is held.</summary>
    public Task Asked => _asked.Task;

    public HeadsetTime Now
    {
        get
        {
            _asked.TrySetResult();
            _goOn.Wait();
            return HeadsetTime.FromSeconds(1);
        }
    }

    public void GoOn() => _goOn.Set();
}
