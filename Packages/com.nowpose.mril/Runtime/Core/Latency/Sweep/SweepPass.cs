using System;
using System.Collections.Generic;
using System.Linq;

namespace Nowpose.Latency.Sweep
{
    /// <summary>Visits of one pass of a sweep, and the rise of the render time from its low loads to its high loads.</summary>
    sealed class SweepPass
    {
        const int MinLoads = 3;

        /// <summary>Minimum significant rise, in standard errors.</summary>
        const double MinStandardErrors = 4;

        /// <summary>Minimum rise, relative to the render time at low loads. A smaller rise cannot be separated from the scatter of frames.</summary>
        const double MinRise = 0.1;

        /// <summary>Rise, relative to the render time at low loads, that cannot be a trend within a short sweep.</summary>
        const double ClearRise = 0.5;

        /// <param name="visits">Visits in chronological order, with three different loads or more.</param>
        SweepPass(IReadOnlyList<SweepVisit> visits, SweepTrend trend)
        {
            var sorted = visits.OrderBy(visit => visit.Vertices).ToList();
            var third = sorted.Count / 3;
            List<SweepVisit> low = sorted.GetRange(0, third), high = sorted.GetRange(sorted.Count - third, third);
            LowMs = low.Average(visit => visit.RenderMs - trend.At(visit));
            HighMs = high.Average(visit => visit.RenderMs - trend.At(visit));
            LowVertices = low.Average(visit => visit.Vertices);
            HighVertices = high.Average(visit => visit.Vertices);
            var variance = trend.Error * trend.Error + low.Concat(high).Sum(visit => visit.RenderError * visit.RenderError) / (third * third);
            NeededMs = Math.Max(MinRise * Math.Abs(LowMs), MinStandardErrors * Math.Sqrt(variance));
        }

        /// <summary>Mean render time at the lowest third of the loads minus the trend, ms.</summary>
        public double LowMs { get; }

        public double HighMs { get; }

        /// <summary>Mean number of vertices of the lowest third of the loads.</summary>
        public double LowVertices { get; }

        public double HighVertices { get; }

        public double RiseMs => HighMs - LowMs;

        /// <summary>Minimum significant rise, ms.</summary>
        public double NeededMs { get; }

        /// <summary>
        /// Splits visits into passes with increasing or with decreasing load. A change that is caused by elapsed time and not by the load appears as
        /// a rise in only one of the two directions. If the sweep has only one direction, the trend at constant load is subtracted. If no pass has
        /// three different loads, all visits together form one pass. The result is empty for fewer than three different loads.
        /// </summary>
        public static List<SweepPass> Of(IReadOnlyList<SweepVisit> visits)
        {
            var runs = RunsOf(visits).Where(IsEnough).ToList();
            if (runs.Count == 0 && IsEnough(visits)) runs.Add(visits.ToList());
            var isUpAndDown = runs.Any(IsUp) && !runs.All(IsUp);
            return runs.ConvertAll(run => isUpAndDown ? new SweepPass(run, SweepTrend.None) : WithoutTrend(run, SweepTrend.Of(visits)));
        }

        // Subtracts the trend, unless the rise is clear but the measured trend is too inaccurate, as in a short sweep.
        static SweepPass WithoutTrend(IReadOnlyList<SweepVisit> run, SweepTrend trend)
        {
            var unchanged = new SweepPass(run, SweepTrend.None);
            var isClear = unchanged.RiseMs >= Math.Max(unchanged.NeededMs, ClearRise * Math.Abs(unchanged.LowMs));
            return isClear && MinStandardErrors * trend.Error > unchanged.RiseMs / 2 ? unchanged : new SweepPass(run, trend);
        }

        static bool IsEnough(IReadOnlyList<SweepVisit> visits) => visits.Select(visit => visit.Vertices).Distinct().Count() >= MinLoads;

        /// <summary>
        /// Splits visits into runs with increasing or with decreasing load. A load at which the direction changes belongs to both runs.
        /// </summary>
        static IEnumerable<List<SweepVisit>> RunsOf(IReadOnlyList<SweepVisit> visits)
        {
            var run = new List<SweepVisit>();
            foreach (var visit in visits)
            {
                if (run.Count >= 2 && visit.Vertices > run[run.Count - 1].Vertices != IsUp(run))
                {
                    yield return run;
                    run = new List<SweepVisit> { run[run.Count - 1] };
                }
                run.Add(visit);
            }
            yield return run;
        }

        static bool IsUp(IReadOnlyList<SweepVisit> run) => run[1].Vertices > run[0].Vertices;
    }
}
