namespace Nowpose.Tests.Common;

/// <summary>A clock that blocks each reading until the test releases it, to simulate a thread that does not end.</summary>
sealed class StuckClock : IHeadsetClock
{
    readonly TaskCompletionSource _asked = new(TaskCreationOptions.RunContinuationsAsynchronously);
    readonly ManualResetEventSlim _goOn = new();

    /// <summary>Completes when a thread is blocked in a reading.</summary>
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
