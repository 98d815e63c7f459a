namespace Nowpose.Tests.Common;

/// <summary>A headset clock that a test sets. Each reading advances the clock by <see cref="Step"/>.</summary>
sealed class SteppedClock : IPerformanceCounterClock
{
    long _ticks;

    /// <summary>Duration that a reading takes.</summary>
    public TimeSpan Step { get; set; } = TimeSpan.FromMicroseconds(1);

    public HeadsetTime Now => new(new TimeSpan(Interlocked.Add(ref _ticks, Step.Ticks)));

    /// <summary>Gets the time of the last reading without advancing the clock.</summary>
    public HeadsetTime Read => new(new TimeSpan(Interlocked.Read(ref _ticks)));

    /// <summary>Frequency of the simulated counter in counts per second.</summary>
    public long CountsPerSecond { get; set; } = 10_000_000;

    public HeadsetTime At(long count) => new(new TimeSpan((long)((Int128)count * TimeSpan.TicksPerSecond / CountsPerSecond)));

    public void Set(double seconds) => Interlocked.Exchange(ref _ticks, TimeSpan.FromSeconds(seconds).Ticks);
}
