namespace Nowpose.Tests.Common;

/// <summary>A time provider that a test advances.</summary>
sealed class SteppedTime : TimeProvider
{
    static readonly DateTimeOffset Start = new(2026, 11, 20, 12, 0, 0, TimeSpan.Zero);

    TimeSpan _now, _correction;

    public override long TimestampFrequency => TimeSpan.TicksPerSecond;
    public override DateTimeOffset GetUtcNow() => Start + _now + _correction;
    public override long GetTimestamp() => _now.Ticks;

    public void Advance(TimeSpan by) => _now += by;

    /// <summary>Corrects the system clock. The timestamp counter does not change.</summary>
    public void Correct(TimeSpan by) => _correction += by;
}
