namespace Nowpose.Headless.Tests.Unity;

/// <summary>A headset clock that a test sets; whoever reads it finds it a microsecond later.</summary>
sealed class SteppedClock : IHeadsetClock
{
    long _ticks;

    public HeadsetTime Now => new(new TimeSpan(Interlocked.Add(ref _ticks, 10)));

    /// <summary>What was read last.</summary>
    public HeadsetTime Read => new(new TimeSpan(Interlocked.Read(ref _ticks)));

    public void Set(double seconds) => Interlocked.Exchange(ref _ticks, TimeSpan.FromSeconds(seconds).Ticks);
}
