namespace Nowpose.Headless.Tests;

/// <summary>A clock that a test sets and that signals each reading.</summary>
sealed class ObservedClock : IHeadsetClock
{
    readonly SemaphoreSlim _reads = new(0);
    long _ticks;

    public HeadsetTime Now
    {
        get
        {
            var now = new HeadsetTime(new TimeSpan(Interlocked.Read(ref _ticks)));
            _reads.Release();
            return now;
        }
        set => Interlocked.Exchange(ref _ticks, value.SinceEpoch.Ticks);
    }

    public async Task ReadAsync() => Assert(await _reads.WaitAsync(Soon.Limit));

    static void Assert(bool read) => NUnit.Framework.Assert.That(read, "the clock is read");
}
