using Nowpose.Protocol;
using Nowpose.Sync;

namespace Nowpose.Headless.Tests.Fuzz;

/// <summary>
/// Simulates a sync server that sends arbitrary replies, and a headset's clock synchronisation, whose model must stay valid for any reply. Not
/// thread-safe.
/// </summary>
sealed class WildServer
{
    static readonly TimeSpan MaxTime = TimeSpan.FromDays(365.25 * 150);

    readonly ClockSynchroniser _clock = new(ClockEstimators.Create(ClockEstimators.Default), ClockSettings.Default);
    readonly ExchangePace _pace = new(TimeSpan.FromMilliseconds(200), TimeSpan.FromSeconds(2), new Random(1));
    HeadsetTime _now = HeadsetTime.FromSeconds(100);

    /// <returns>Whether the clock model used the reply.</returns>
    public bool Reply(int seed)
    {
        var random = new Random(seed);
        var t1 = _now;
        _now += new TimeSpan(random.NextInt64(1, 2_000_000));
        var reply = FrameMutator.Reply(random, (uint)seed, t1.Nanoseconds);
        var verdict = SyncVerdict.Dropped;
        // Adds correct exchanges, so that the clock model is not empty when it receives the false ones.
        if (random.Next(3) == 0)
            reply = new SyncFrame(SyncFrameKind.Reply, 0, (uint)seed, 0, t1.Nanoseconds, t1.Nanoseconds + 500_000, t1.Nanoseconds + 600_000, 0);
        if (reply.Sequence == (uint)seed && reply.T1Ns == t1.Nanoseconds) verdict = Take(random, t1, reply);
        _now += new TimeSpan(random.NextInt64(1, 3_000_000));
        return verdict == SyncVerdict.Consistent;
    }

    SyncVerdict Take(Random random, HeadsetTime sent, in SyncFrame reply)
    {
        var exchange = SyncExchange.Of(sent, reply, _now);
        if (SyncExchangeRules.CheckReply(exchange, reply) != SyncExchangeFault.None) return SyncVerdict.Dropped;
        var verdict = _clock.Add(exchange, out _);
        var at = _now + new TimeSpan(random.NextInt64(0, 100_000_000));
        var model = _clock.ModelAt(at);
        if (model.IsKnown && (model.ErrorBound < TimeSpan.Zero || !double.IsFinite(model.Skew)))
            throw new FuzzException($"bound {model.ErrorBound}, skew {model.Skew}");
        if (model.IsKnown && model.ToControl(at).SinceEpoch.Duration() > MaxTime) throw new FuzzException("control time " + model.ToControl(at).SinceEpoch);
        var pause = _pace.Next(_clock, _now);
        if (pause <= TimeSpan.Zero || pause > TimeSpan.FromMinutes(1)) throw new FuzzException("a pause of " + pause);
        return verdict;
    }
}
