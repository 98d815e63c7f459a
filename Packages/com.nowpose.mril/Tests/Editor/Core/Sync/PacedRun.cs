using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Sync;
using Nowpose.Sync.Envelope;

namespace Nowpose.Tests.Core.Sync
{
    /// <summary>
    /// Runs exchanges as the client does. Each exchange starts at the time that the pace returns, but not before the previous exchange
    /// has ended.
    /// </summary>
    sealed class PacedRun
    {
        static readonly TimeSpan RetryInterval = TimeSpan.FromMilliseconds(200);

        readonly ExchangePace _pace;
        readonly Random _lateness;
        readonly double _latestMs;
        double _now;

        /// <param name="latestMs">Maximum delay of the thread's wake-up in ms. The delay is uniformly distributed.</param>
        public PacedRun(double configuredMs = 200, int seed = 1, double latestMs = 0, bool maySlow = true)
        {
            _pace = new ExchangePace(Lengths.Ms(configuredMs), TimeSpan.FromSeconds(2), new Random(seed), maySlow: maySlow);
            _lateness = new Random(seed + 1);
            _latestMs = latestMs;
        }

        public ClockSynchroniser Clock { get; } = new ClockSynchroniser(new DefaultClockEstimator(), ClockSettings.Default);
        public List<(double At, double PauseMs)> Exchanges { get; } = new List<(double, double)>();
        public List<(double At, double ErrorMs, double BoundMs, bool IsTrusted)> Errors { get; } = new List<(double, double, double, bool)>();

        public void Run(SimulatedLink link, double until)
        {
            while (_now < until)
            {
                var start = HeadsetTime.FromSeconds(_now);
                while (!link.TryExchange(start, out _)) start += RetryInterval;
                link.TryExchange(start, out var exchange);
                Clock.Add(exchange, out _);
                var pause = _pace.Next(Clock, exchange.T4);
                Exchanges.Add((_now, pause.TotalMilliseconds));
                var due = start + pause + Lengths.Ms(_latestMs * _lateness.NextDouble());
                var next = Math.Max(due.SinceEpoch.TotalSeconds, exchange.T4.SinceEpoch.TotalSeconds);
                for (var s = exchange.T4.SinceEpoch.TotalSeconds; s < next; s += 0.05)
                {
                    var at = HeadsetTime.FromSeconds(s);
                    var model = Clock.ModelAt(at);
                    var error = model.OffsetAt(at) - link.TrueOffset(at);
                    Errors.Add((s, error.TotalMilliseconds, model.ErrorBound.TotalMilliseconds, ClockSettings.Default.Trusts(model)));
                }
                _now = next;
            }
        }

        public void Sleep(double until) => _now = until;

        public IEnumerable<double> Pauses(double from, double to) => Exchanges.Where(e => e.At >= from && e.At < to).Select(e => e.PauseMs);

        public double P95Ms(double from)
        {
            var sorted = Errors.Where(e => e.At >= from).Select(e => Math.Abs(e.ErrorMs)).OrderBy(e => e).ToArray();
            return sorted[(int)(0.95 * (sorted.Length - 1))];
        }
    }
}
