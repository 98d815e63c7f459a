using System.Diagnostics;
using Nowpose.Cli;
using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Benchmarks.Load;

/// <summary>A headset with the complete runtime. Its clock is compared with the true time in each frame.</summary>
sealed class SampledHeadset : IDisposable
{
    static readonly TimeSpan Frame = TimeSpan.FromMilliseconds(1000 / 60.0);

    readonly StopwatchHeadsetClock _clock = new();
    readonly CompensationSession _session;
    readonly ControlTruth _truth;
    readonly List<double> _errorsUs = [];
    readonly CancellationTokenSource _stop = new();
    readonly Thread _thread;
    bool _isMeasuring;

    public SampledHeadset(GatewayProcess gateway, ControlTruth truth)
    {
        _truth = truth;
        var connection = new ConnectionSettings(gateway.Sync.Address.ToString(), gateway.Sync.Port, gateway.WebSocket.Port);
        _session = new CompensationSession(
            new SessionSettings(connection, VisualisationLatency.FromMilliseconds(40)), RobotFiles.Load("youbot"), _clock);
        _session.Connect();
        _thread = new Thread(Run) { IsBackground = true, Name = "sampled headset" };
        _thread.Start();
    }

    /// <summary>Starts the measurement. Discards earlier values.</summary>
    public void Measure()
    {
        lock (_errorsUs)
        {
            _errorsUs.Clear();
            _isMeasuring = true;
        }
    }

    /// <summary>Gets a quantile of the absolute error of the control time, µs; NaN while the clock is unknown.</summary>
    public double ErrorUs(double share)
    {
        lock (_errorsUs)
        {
            return Quantile.OfOrNull(_errorsUs, share) ?? double.NaN;
        }
    }

    public void Dispose()
    {
        _stop.Cancel();
        _thread.Join();
        _session.Dispose();
        _stop.Dispose();
    }

    void Run()
    {
        while (!_stop.Token.WaitHandle.WaitOne(Frame))
        {
            _session.Tick(_clock.Now);
            var before = Stopwatch.GetTimestamp();
            var now = _clock.Now;
            var count = before + ((Stopwatch.GetTimestamp() - before) / 2);
            var model = _session.Clock.ModelAt(now);
            if (model.State != ClockState.Synchronised) continue;
            var errorUs = Math.Abs(model.ToControl(now).Nanoseconds - _truth.NanosecondsAt(count)) / 1000.0;
            lock (_errorsUs)
                if (_isMeasuring) _errorsUs.Add(errorUs);
        }
    }
}
