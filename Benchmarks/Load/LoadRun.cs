using System.Diagnostics;

namespace Nowpose.Benchmarks.Load;

/// <summary>Connects headsets to a gateway and measures the gateway. The number of headsets can increase between measurements.</summary>
sealed class LoadRun : IDisposable
{
    /// <summary>Number of concurrent connection attempts. The gateway limits the pending connections of an address.</summary>
    const int ConnectingAtOnce = 8;

    readonly GatewayProcess _gateway;
    readonly ControlTruth _truth;
    readonly SampledHeadset _sampled;
    readonly LatencyCounts _latencies = new();
    readonly List<LeanHeadset> _headsets = [];
    readonly CancellationTokenSource _stop = new();
    readonly Task _stalled;
    readonly double _rateHz;

    LoadRun(GatewayProcess gateway, double rateHz)
    {
        _gateway = gateway;
        _rateHz = rateHz;
        _truth = ControlTruth.Measure(gateway.Sync);
        _sampled = new SampledHeadset(gateway, _truth);
        _stalled = StalledHeadset.RunAsync(gateway, _stop.Token);
    }

    /// <inheritdoc cref="GatewayProcess.StartAsync(double, int, string)"/>
    public static async Task<LoadRun> StartAsync(double rateHz, int connections, string program = null)
    {
        var gateway = await GatewayProcess.StartAsync(rateHz, connections, program);
        try
        {
            return new LoadRun(gateway, rateHz);
        }
        catch
        {
            // The gateway is a separate process and would otherwise continue to run after this one.
            gateway.Dispose();
            throw;
        }
    }

    /// <summary>Measures the gateway with a number of headsets. The number must not decrease between calls.</summary>
    public async Task<LoadResult> MeasureAsync(LoadSettings settings, CancellationToken stop)
    {
        await ConnectAsync(settings.Headsets, stop);
        await Task.Delay(settings.WarmUp, stop);
        _latencies.Clear();
        foreach (var headset in _headsets) headset.Clear();
        _sampled.Measure();
        using var self = Process.GetCurrentProcess();
        var (since, gatewayBefore, selfBefore) = (Stopwatch.GetTimestamp(), _gateway.ProcessorTime, self.TotalProcessorTime);
        var memory = await WatchAsync(settings, stop);
        var seconds = Stopwatch.GetElapsedTime(since).TotalSeconds;
        self.Refresh();
        foreach (var problem in _headsets.Where(headset => headset.Problem != null).GroupBy(headset => headset.Problem))
            Console.Error.WriteLine($"{problem.Count()} ended: {problem.Key}");
        var messages = _headsets.Sum(headset => headset.Received);
        return new LoadResult(
            settings.Headsets, _rateHz, seconds, messages, messages / seconds, _headsets.Sum(headset => headset.Lost),
            _headsets.Count(headset => headset.Problem != null), _headsets.Sum(headset => headset.Refused),
            _latencies.Quantile(0.5).TotalMilliseconds, _latencies.Quantile(0.99).TotalMilliseconds, _latencies.Maximum.TotalMilliseconds,
            _sampled.ErrorUs(0.5), _sampled.ErrorUs(0.95), _truth.Bound.TotalMicroseconds,
            memory.MeanMiB, memory.MaxMiB, memory.Deviation,
            (_gateway.ProcessorTime - gatewayBefore).TotalSeconds / seconds, (self.TotalProcessorTime - selfBefore).TotalSeconds / seconds);
    }

    public void Dispose()
    {
        _stop.Cancel();
        foreach (var headset in _headsets) headset.Dispose();
        _sampled.Dispose();
        _gateway.Dispose();
        _stalled.Wait();
        _stop.Dispose();
    }

    async Task ConnectAsync(int count, CancellationToken stop)
    {
        while (_headsets.Count < count)
        {
            stop.ThrowIfCancellationRequested();
            var next = Enumerable.Range(_headsets.Count, Math.Min(ConnectingAtOnce, count - _headsets.Count))
                .Select(i => new LeanHeadset($"load {i}", _rateHz, _latencies, _truth)).ToArray();
            _headsets.AddRange(next);
            await Task.WhenAll(next.Select(headset => headset.OpenAsync(_gateway)));
            foreach (var headset in next) _ = headset.RunAsync();
        }
    }

    async Task<MemoryWatch> WatchAsync(LoadSettings settings, CancellationToken stop)
    {
        var memory = new MemoryWatch();
        for (var second = 1; second <= settings.Length.TotalSeconds; second++)
        {
            await Task.Delay(TimeSpan.FromSeconds(1), stop);
            memory.Add(_gateway.ResidentBytes);
            if (second % 10 == 0)
                Console.Error.WriteLine(FormattableString.Invariant(
                    $"{settings.Headsets} headsets, {second} s: P99 {_latencies.Quantile(0.99).TotalMilliseconds:0.00} ms, {memory.MeanMiB:0} MiB"));
        }

        return memory;
    }
}

/// <summary>Settings of the load on a gateway.</summary>
/// <param name="WarmUp">Time before the measurement in which connections settle, code is compiled and the gateway's memory reaches its final size.</param>
sealed record LoadSettings(int Headsets, double RateHz, TimeSpan Length, TimeSpan WarmUp);
