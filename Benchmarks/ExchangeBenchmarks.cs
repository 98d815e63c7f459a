using BenchmarkDotNet.Attributes;
using Nowpose.Simulation;
using Nowpose.Sync;

namespace Nowpose.Benchmarks;

/// <summary>Measures one sync exchange over good WiFi with a full history: checks, bounds, step detection and fit.</summary>
public class ExchangeBenchmarks
{
    const int Delays = 1024;
    static readonly TimeSpan Interval = TimeSpan.FromMilliseconds(200);

    readonly ClockSynchroniser _ours = new(ClockEstimators.Create(ClockEstimators.Default), ClockSettings.Default);
    readonly ClockSynchroniser _papers = new(ClockEstimators.Create(ClockEstimators.Ransac), ClockSettings.Default);
    readonly TimeSpan[] _up = DelaysOf(NetworkProfile.Wifi.Up(1));
    readonly TimeSpan[] _down = DelaysOf(NetworkProfile.Wifi.Down(2));
    HeadsetTime _now;
    int _next;

    [GlobalSetup]
    public void Prepare()
    {
        for (var i = 0; i < Delays; i++)
        {
            if (AddTo(_ours) != SyncVerdict.Consistent) throw new InvalidOperationException("an exchange is not used");
            AddToPapers();
        }
    }

    [Benchmark(Description = "Exchange: added to a full history of 900")]
    public int Add() => (int)AddTo(_ours);

    [Benchmark(Description = "Exchange: added to the paper's full history of 100")]
    public int AddToPapers() => (int)AddTo(_papers);

    SyncVerdict AddTo(ClockSynchroniser clock)
    {
        _next = (_next + 1) % Delays;
        _now += Interval;
        // Both clocks show the same time. The amount of work does not depend on the offset.
        var there = new ControlTime(_now.SinceEpoch + _up[_next]);
        return clock.Add(new SyncExchange(_now, there, there, _now + _up[_next] + _down[_next]), out _);
    }

    static TimeSpan[] DelaysOf(PathDelay path) => [.. Enumerable.Range(0, Delays).Select(_ => path.Next())];
}
