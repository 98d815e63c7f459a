using System;
using System.Collections.Generic;

namespace Nowpose.Latency.Sweep
{
    /// <summary>
    /// Trend of the render time in a sweep: its increase that is caused by elapsed time and not by the load, in ms. Accumulated from the rates at
    /// constant load.
    /// </summary>
    sealed class SweepTrend
    {
        readonly Dictionary<SweepVisit, double> _sums = new Dictionary<SweepVisit, double>();

        SweepTrend() { }

        /// <summary>Zero trend.</summary>
        public static SweepTrend None { get; } = new SweepTrend();

        /// <summary>Standard deviation of the total trend, ms.</summary>
        public double Error { get; private set; }

        public static SweepTrend Of(IReadOnlyList<SweepVisit> visits)
        {
            var trend = new SweepTrend();
            double sum = 0, variance = 0;
            for (var i = 0; i < visits.Count; i++)
            {
                if (i > 0)
                {
                    SweepVisit a = visits[i - 1], b = visits[i];
                    var seconds = b.Middle - a.Middle;
                    sum += (a.Trend + b.Trend) / 2 * seconds;
                    variance += (a.TrendVariance + b.TrendVariance) / 2 * seconds * seconds;
                }
                trend._sums.Add(visits[i], sum);
            }
            trend.Error = Math.Sqrt(variance);
            return trend;
        }

        public double At(SweepVisit visit) => _sums.TryGetValue(visit, out var sum) ? sum : 0;
    }
}
