using Nowpose.Gateway.Messages;
using Nowpose.Sync;

namespace Nowpose.Gateway.Clock;

/// <summary>One clock of the control system, offered by an adapter, and its estimate from sync exchanges with that adapter.</summary>
/// <remarks>
/// In these exchanges, the gateway acts like a headset, with this machine's counter as C2. The estimate is kept when the adapter
/// disconnects, and continues when an adapter offers a clock of the same name again. Thread-safe.
/// </remarks>
public sealed class PlantClock
{
    /// <summary>
    /// Time without a response after which another adapter may offer this clock. It is shorter than the timeout of a lost connection's pings.
    /// </summary>
    internal static readonly TimeSpan TakeoverTimeout = TimeSpan.FromSeconds(3);

    internal const int MaxFailureLength = 200;

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

    /// <summary>Whether an adapter offers the clock at present.</summary>
    public bool IsConnected => Volatile.Read(ref _caller) != null;

    /// <summary>Raised for each exchange with its result, on the thread that made it. Handlers must be quick and must not throw.</summary>
    internal event SyncExchangeHandler Judged;

    /// <summary>Number of usable exchanges since the gateway started.</summary>
    public long Exchanges => Interlocked.Read(ref _exchanges);

    /// <summary>Number of requests without a usable response since the gateway started.</summary>
    public long Failures => Interlocked.Read(ref _failures);

    /// <summary>The reason for the newest failure; null if there is none.</summary>
    public string LastFailure => _lastFailure;

    /// <summary>The current estimate. Φ is this machine's counter minus this clock.</summary>
    public ClockModel Model => _synchroniser.ModelAt(_counter.Now);

    public TimeSpan RoundTripTime => _synchroniser.RoundTripTime;
    public TimeSpan Resolution => _synchroniser.Resolution;

    internal ClockSynchroniser Synchroniser => _synchroniser;

    /// <summary>Whether an adapter may take over this clock: no adapter offers it, or the current one has not responded for 3 s.</summary>
    internal bool IsFree
    {
        get
        {
            lock (_gate) return _caller == null || _counter.Now - _heard >= TakeoverTimeout;
        }
    }

    internal bool IsAskedBy(PlantClockCaller caller) => Volatile.Read(ref _caller) == caller;

    /// <summary>Sets the adapter that offers this clock. The previous adapter receives no more requests.</summary>
    /// <returns>False if <see cref="IsFree"/> is false; the current adapter then remains attached.</returns>
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

    /// <summary>Records that an adapter has responded, with or without a time.</summary>
    /// <returns>Whether this adapter is the current one.</returns>
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
        else Failed(PlantClockMessages.ExchangeUnusable(fault));
    }

    /// <param name="why">The reason; may contain text from a peer.</param>
    internal void Failed(string why)
    {
        _lastFailure = InputException.OneLine(why, MaxFailureLength);
        Interlocked.Increment(ref _failures);
    }
}
