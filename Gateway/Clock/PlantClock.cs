using Nowpose.Sync;

namespace Nowpose.Gateway.Clock;

/// <summary>One clock of the control system, as its adapter tells it: measured against this machine's counter as a headset measures C1.</summary>
/// <remarks>
/// The gateway is the headset of these exchanges: its counter stands in the place of C2. What was learned stays when the adapter goes,
/// and is gone on with when one of the same name comes. Any thread.
/// </remarks>
public sealed class PlantClock
{
    /// <summary>Whoever was asked for so long without an answer may be gone: its connection ends only when pings find out.</summary>
    internal static readonly TimeSpan SilenceOfTheGone = TimeSpan.FromSeconds(3);

    internal const int LongestFailure = 200;

    readonly ClockSynchroniser _synchroniser = new(ClockEstimators.Create(ClockEstimators.Default), ClockSettings.Default);
    readonly IHeadsetClock _counter;
    readonly object _gate = new();
    PlantClockCaller _caller;
    HeadsetTime _heard;
    long _exchanges, _failures;
    volatile string _lastFailure;

    internal PlantClock(string name, IHeadsetClock counter)
    {
        Name = name;
        _counter = counter;
        _synchroniser.Judged += (in SyncExchange exchange, SyncVerdict verdict, SyncExchangeFault fault) => Judged?.Invoke(exchange, verdict, fault);
    }

    public string Name { get; }

    /// <summary>Whether an adapter offers it at present.</summary>
    public bool IsConnected => Volatile.Read(ref _caller) != null;

    /// <summary>Each exchange with what became of it, on the thread that made it. A handler must be quick and must not throw.</summary>
    internal event SyncExchangeHandler Judged;

    /// <summary>Exchanges that could be used, and questions that were not answered or not usably, since the start.</summary>
    public long Exchanges => Interlocked.Read(ref _exchanges);

    /// <inheritdoc cref="Exchanges"/>
    public long Failures => Interlocked.Read(ref _failures);

    /// <summary>Why the newest of the failures; null without one.</summary>
    public string LastFailure => _lastFailure;

    /// <summary>What is known of it now; Φ is this machine's counter less this clock.</summary>
    public ClockModel Model => _synchroniser.ModelAt(_counter.Now);

    public TimeSpan RoundTripTime => _synchroniser.RoundTripTime;
    public TimeSpan Resolution => _synchroniser.Resolution;

    internal ClockSynchroniser Synchroniser => _synchroniser;

    /// <summary>Whether nobody answers for this clock, or whoever did has been silent for long.</summary>
    internal bool IsFree
    {
        get
        {
            lock (_gate) return _caller == null || _counter.Now - _heard >= SilenceOfTheGone;
        }
    }

    internal bool IsAskedBy(PlantClockCaller caller) => Volatile.Read(ref _caller) == caller;

    /// <summary>Takes the place of who answers for this clock; whoever had it before is asked no more.</summary>
    /// <returns>False while it is not <see cref="IsFree"/>.</returns>
    internal bool TryAttach(PlantClockCaller caller)
    {
        PlantClockCaller former;
        lock (_gate)
        {
            if (!IsFree) return false;
            former = _caller;
            _caller = caller;
            _heard = _counter.Now;
        }

        former?.Dispose();
        return true;
    }

    /// <summary>Somebody answered, with a time or without.</summary>
    /// <returns>Whether it is the one that is asked.</returns>
    internal bool TryHear(PlantClockCaller caller)
    {
        lock (_gate)
        {
            if (_caller != caller) return false;
            _heard = _counter.Now;
            return true;
        }
    }

    internal void Detach(PlantClockCaller caller)
    {
        lock (_gate)
        {
            if (_caller == caller) _caller = null;
        }
    }

    internal void Add(in SyncExchange exchange)
    {
        _synchroniser.Add(exchange, out var fault);
        if (fault == SyncExchangeFault.None) Interlocked.Increment(ref _exchanges);
        else Failed($"the exchange was unusable: {fault}");
    }

    /// <param name="why">May be a peer's own words.</param>
    internal void Failed(string why)
    {
        _lastFailure = InputException.OneLine(why, LongestFailure);
        Interlocked.Increment(ref _failures);
    }
}
