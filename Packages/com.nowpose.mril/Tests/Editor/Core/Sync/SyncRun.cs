using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Sync;

namespace Nowpose.Tests.Core.Sync
{
    /// <summary>
    /// Runs a synchroniser over a simulated link, by default with an exchange every 200 ms. The error of the clock model is computed ten times per
    /// interval.
    /// </summary>
    sealed class SyncRun
    {
        readonly List<(double At, double ErrorMs, ClockModel Model)> _instants = new List<(double, double, ClockModel)>();

        public ClockSynchroniser Clock { get; }

        public SyncRun(IClockEstimator estimator) => Clock = new ClockSynchroniser(estimator, ClockSettings.Default);

        public void Run(SimulatedLink link, double fromSeconds, double toSeconds, bool exchange = true, double intervalSeconds = 0.2)
        {
            var pending = new Queue<SyncExchange>();
            var next = fromSeconds;
            var step = intervalSeconds / 10;
            // The list would otherwise be copied each time it has doubled, which takes a tenth of the time of a long run.
            var count = _instants.Count + (int)((toSeconds - fromSeconds) / step) + 2;
            if (count > 2 * _instants.Capacity) _instants.Capacity = count;
            for (var s = fromSeconds; s < toSeconds; s += step)
            {
                var now = HeadsetTime.FromSeconds(s);
                while (pending.Count > 0 && pending.Peek().T4 <= now)
                    Clock.Add(pending.Dequeue(), out _);
                if (exchange && s >= next && pending.Count == 0)
                {
                    if (link.TryExchange(now, out var each)) pending.Enqueue(each);
                    next += intervalSeconds;
                }
                var model = Clock.ModelAt(now);
                var error = model.IsKnown ? (model.OffsetAt(now) - link.TrueOffset(now)).TotalMilliseconds : double.NaN;
                _instants.Add((s, error, model));
            }
        }

        public double[] ErrorsMs(double after) =>
            _instants.Where(i => i.At >= after).Select(i => Math.Abs(i.ErrorMs)).ToArray();

        public double PercentileMs(double after, double fraction)
        {
            var sorted = ErrorsMs(after).OrderBy(e => e).ToArray();
            return sorted[(int)(fraction * (sorted.Length - 1))];
        }

        public double FirstAt(Func<ClockModel, bool> condition) => _instants.First(i => condition(i.Model)).At;

        public IEnumerable<(double At, double ErrorMs, ClockModel Model)> Instants => _instants;
    }
}
