namespace Nowpose.Tests.Common;

/// <summary>A headset clock that a test sets; whoever reads it finds it a little later, as after some work.</summary>
sealed class SteppedClock : IPerformanceCounterClock
{
    long _ticks;

    /// <summary>What one reading takes.</summary>
    public TimeSpan Step { get; set; } = TimeSpan.FromMicroseconds(1);

    public HeadsetTime Now => new(new TimeSpan(Interlocked.Add(ref _ticks, Step.Ticks)));

    /// <summary>What was read last.</summary>
    public HeadsetTime Read => new(new TimeSpan(Interlocked.Read(ref _ticks)));

    /// <summary>Counts in a second of the counter that it plays.</summary>
    public long CountsPerSecond { get; set; } = 10_000_000;

    public HeadsetTime At(long count) => new(new TimeSpan((long)((Int128)count * TimeSpan.TicksPerSecond / CountsPerSecond)));

    public void Set(double seconds) => Interlocked.Exchange(ref _ticks, TimeSpan.FromSeconds(seconds).Ticks);
}
