using System;
using System.Collections.Generic;

namespace Nowpose.Latency.Sweep
{
    /// <summary>
    /// Drift of a sweep: increase of the render time that is caused by elapsed time and not by the load, in ms. Accumulated from the rates at
    /// constant load.
    /// </summary>
    sealed class SweepDrift
    {
        readonly Dictionary<SweepVisit, double> _sums = new Dictionary<SweepVisit, double>();

        SweepDrift() { }

        /// <summary>Zero drift.</summary>
        public static SweepDrift None { get; } = new SweepDrift();

        /// <summary>Standard deviation of the total drift, ms.</summary>
        public double Error { get; private set; }

        public static SweepDrift Of(IReadOnlyList<SweepVisit> visits)
        {
            var drift = new SweepDrift();
            double sum = 0, variance = 0;
            for (var i = 0; i < visits.Count; i++)
            {
                if (i > 0)
                {
                    SweepVisit a = visits[i - 1], b = visits[i];
                    var seconds = b.Middle - a.Middle;
                    sum += (a.Drift + b.Drift) / 2 * seconds;
                    variance += (a.DriftVariance + b.DriftVariance) / 2 * seconds * seconds;
                }
                drift._sums.Add(visits[i], sum);
            }
            drift.Error = Math.Sqrt(variance);
            return drift;
        }

        public double At(SweepVisit visit) => _sums.TryGetValue(visit, out var sum) ? sum : 0;
    }
}
