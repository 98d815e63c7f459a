namespace Nowpose.Tests.Common;

/// <summary>A time provider that a test advances, with timers.</summary>
sealed class SteppedTimers : TimeProvider
{
    readonly List<Timer> _timers = [];
    readonly SteppedTime _time = new();

    public override long TimestampFrequency => _time.TimestampFrequency;
    public override DateTimeOffset GetUtcNow() => _time.GetUtcNow();
    public override long GetTimestamp() => _time.GetTimestamp();

    /// <inheritdoc cref="SteppedTime.Correct"/>
    public void Correct(TimeSpan by) => _time.Correct(by);

    /// <summary>Advances the time and fires the timers that become due, on the calling thread.</summary>
    /// <param name="fired">Called after each timer that has fired; null for nothing.</param>
    public void Advance(TimeSpan by, Action fired = null)
    {
        var end = GetTimestamp() + by.Ticks;
        while (_timers.Where(timer => timer.Due <= end).MinBy(timer => timer.Due) is { } next)
        {
            _time.Advance(new TimeSpan(next.Due - GetTimestamp()));
            next.Fire();
            fired?.Invoke();
        }

        _time.Advance(new TimeSpan(end - GetTimestamp()));
    }

    public override ITimer CreateTimer(TimerCallback callback, object state, TimeSpan dueTime, TimeSpan period)
    {
        var timer = new Timer(this, () => callback(state));
        _timers.Add(timer);
        timer.Change(dueTime, period);
        return timer;
    }

    sealed class Timer(SteppedTimers time, Action fire) : ITimer
    {
        TimeSpan _period;

        public long Due { get; private set; } = long.MaxValue;

        public bool Change(TimeSpan dueTime, TimeSpan period)
        {
            _period = period;
            Due = dueTime == Timeout.InfiniteTimeSpan ? long.MaxValue : time.GetTimestamp() + dueTime.Ticks;
            return true;
        }

        public void Fire()
        {
            Due = _period == Timeout.InfiniteTimeSpan ? long.MaxValue : Due + _period.Ticks;
            fire();
        }

        public void Dispose() => time._timers.Remove(this);

        public ValueTask DisposeAsync()
        {
            Dispose();
            return ValueTask.CompletedTask;
        }
    }
}
