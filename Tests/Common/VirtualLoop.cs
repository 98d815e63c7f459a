namespace Nowpose.Tests.Common;

/// <summary>Virtual time, and a loop that runs all that waits for it on one thread, so that a run depends only on its seed.</summary>
sealed class VirtualLoop : SynchronizationContext, IPerformanceCounterClock
{
    /// <summary>Maximum number of actions and timers at one instant. More of them wait for nothing.</summary>
    const int MaxActions = 100_000;

    readonly SteppedTimers _time = new();
    readonly Queue<Action> _posted = [];
    long _instant;
    int _actions;

    public TimeProvider Time => _time;

    /// <summary>Time since the start, s.</summary>
    public double Seconds => _time.GetTimestamp() / (double)TimeSpan.TicksPerSecond;

    public HeadsetTime Now => At(_time.GetTimestamp());

    public HeadsetTime At(long count) => new(new TimeSpan(count));

    /// <inheritdoc cref="SteppedTime.Correct"/>
    public void Correct(TimeSpan by) => _time.Correct(by);

    /// <summary>Calls an action that runs this loop on the calling thread.</summary>
    public void Enter(Action action)
    {
        var before = Current;
        SetSynchronizationContext(this);
        try
        {
            action();
        }
        finally
        {
            SetSynchronizationContext(before);
        }
    }

    public override void Post(SendOrPostCallback d, object state)
    {
        lock (_posted) _posted.Enqueue(() => d(state));
    }

    /// <summary>Advances the time and runs all that becomes due.</summary>
    /// <inheritdoc cref="Settle" path="/exception"/>
    public void RunUntil(double seconds)
    {
        Settle();
        _time.Advance(TimeSpan.FromSeconds(Math.Max(0, seconds - Seconds)), () =>
        {
            Count();
            Settle();
        });
    }

    /// <summary>Runs all that is due now.</summary>
    /// <exception cref="InvalidOperationException">It does not end, because something runs in a loop without a wait.</exception>
    public void Settle()
    {
        while (true)
        {
            Action next;
            lock (_posted)
                if (!_posted.TryDequeue(out next)) return;
            Count();
            next();
        }
    }

    void Count()
    {
        (_actions, _instant) = (_instant == _time.GetTimestamp() ? _actions + 1 : 0, _time.GetTimestamp());
        if (_actions > MaxActions) throw new InvalidOperationException($"At {Seconds} s, something runs in a loop without a wait.");
    }
}
