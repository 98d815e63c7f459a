using System.Collections.Immutable;
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

    readonly IHeadsetClock _counter;
    readonly ClockRate _rate = new();
    readonly object _gate = new();
    volatile ClockSynchroniser _synchroniser;
    ImmutableArray<PlantClock> _others = [];
    PlantClockCaller _caller;
    HeadsetTime _heard;
    long _exchanges, _failures;
    volatile string _lastFailure;

    internal PlantClock(string name, IHeadsetClock counter)
    {
        Name = name;
        _counter = counter;
        _synchroniser = NewSynchroniser();
    }

    public string Name { get; }

    internal IHeadsetClock Counter => _counter;

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

    /// <summary>The current estimate. Φ is this machine's counter minus this clock. While the rate is wrong, the state is converging.</summary>
    public ClockModel Model
    {
        get
        {
            var model = _synchroniser.ModelAt(_counter.Now);
            return !model.IsKnown || WrongRate == null ? model : new ClockModel(
                model.Reference, model.ReferenceOffset, model.Skew, model.ErrorBound, ClockState.Converging, model.Steps, model.EstimatedError);
        }
    }

    /// <summary>
    /// Rate of this clock relative to this machine's counter if the clock does not run in real time, for example 0.5; null otherwise. Remains while
    /// no adapter sends times.
    /// </summary>
    public double? WrongRate => _rate.Wrong;

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

    /// <summary>Clients whose clock of this name differs from this clock by more than the error bounds of both.</summary>
    internal IEnumerable<ClockContradiction> Contradictions =>
        from other in _others
        let ahead = other.ContradictionWith(this)
        where ahead != null
        select new ClockContradiction(Name, Client, other.Client, ahead.Value);

    internal bool IsAskedBy(PlantClockCaller caller) => Volatile.Read(ref _caller) == caller;

    /// <summary>
    /// Sets the adapter that offers this clock. The previous adapter receives no more requests. Starts a new estimate if the new adapter has another
    /// clock, because exchanges with two clocks cannot be combined, or if the rate was wrong.
    /// </summary>
    /// <param name="measured">The clock of the new adapter as measured so far; null if it is unknown.</param>
    /// <returns>False if <see cref="IsFree"/> is false; the current adapter then remains attached.</returns>
    internal bool TryAttach(PlantClockCaller caller, PlantClock measured = null)
    {
        PlantClockCaller former;
        lock (_gate)
        {
            if (!IsFree) return false;
            former = _caller;
            _caller = caller;
            _heard = _counter.Now;
            if (measured?.ContradictionWith(this) != null || WrongRate != null) _synchroniser = NewSynchroniser();
            _rate.Clear();
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

    /// <summary>Adds the clock of a client that offers a clock of this name while another client serves it.</summary>
    internal void AddOther(PlantClock other) => ImmutableInterlocked.Update(ref _others, all => all.Add(other));

    internal void RemoveOther(PlantClock other) => ImmutableInterlocked.Update(ref _others, all => all.Remove(other));

    internal void Add(in SyncExchange exchange)
    {
        _synchroniser.Add(exchange, out var fault);
        if (fault == SyncExchangeFault.None)
        {
            _rate.Add(exchange);
            Interlocked.Increment(ref _exchanges);
        }
        else Failed(PlantClockMessages.ExchangeUnusable(fault));
    }

    /// <param name="why">The reason; may contain text from a peer.</param>
    internal void Failed(string why)
    {
        _lastFailure = InputException.OneLine(why, MaxFailureLength);
        Interlocked.Increment(ref _failures);
    }

    string Client => Volatile.Read(ref _caller)?.Client?.Title ?? "";

    // Returns the time of this clock minus the time of another clock if their error bounds do not explain it; null otherwise.
    TimeSpan? ContradictionWith(PlantClock other)
    {
        var (mine, theirs, now) = (Model, other.Model, _counter.Now);
        if (!ClockSettings.Default.Trusts(mine) || !ClockSettings.Default.Trusts(theirs)) return null;
        var ahead = mine.ToControl(now) - theirs.ToControl(now);
        return ahead.Duration() > mine.ErrorBound + theirs.ErrorBound ? ahead : null;
    }

    ClockSynchroniser NewSynchroniser()
    {
        var synchroniser = new ClockSynchroniser(ClockEstimators.Create(ClockEstimators.Default), ClockSettings.Default);
        synchroniser.Judged += (in SyncExchange exchange, SyncVerdict verdict, SyncExchangeFault fault) => Judged?.Invoke(exchange, verdict, fault);
        return synchroniser;
    }
}

/// <summary>Two clients that offer clocks of the same name, whose times differ by more than the error bounds of both.</summary>
/// <param name="Client">The client that serves the clock.</param>
/// <param name="Ahead">Time of the other client's clock minus the time of the served clock.</param>
sealed record ClockContradiction(string Clock, string Client, string Other, TimeSpan Ahead);
