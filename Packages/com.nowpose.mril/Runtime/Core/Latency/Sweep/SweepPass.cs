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
        const double Certainty = 4;

        /// <summary>Minimum rise, relative to the render time at low loads. A smaller rise cannot be separated from the scatter of frames.</summary>
        const double MinRise = 0.1;

        /// <summary>Rise, relative to the render time at low loads, that cannot be drift within a short sweep.</summary>
        const double PlainRise = 0.5;

        /// <param name="visits">Visits in chronological order, with three different loads or more.</param>
        SweepPass(IReadOnlyList<SweepVisit> visits, SweepDrift drift)
        {
            var sorted = visits.OrderBy(visit => visit.Vertices).ToList();
            var third = sorted.Count / 3;
            List<SweepVisit> low = sorted.GetRange(0, third), high = sorted.GetRange(sorted.Count - third, third);
            LowMs = low.Average(visit => visit.RenderMs - drift.At(visit));
            HighMs = high.Average(visit => visit.RenderMs - drift.At(visit));
            LowVertices = low.Average(visit => visit.Vertices);
            HighVertices = high.Average(visit => visit.Vertices);
            var variance = drift.Error * drift.Error + low.Concat(high).Sum(visit => visit.RenderError * visit.RenderError) / (third * third);
            NeededMs = Math.Max(MinRise * Math.Abs(LowMs), Certainty * Math.Sqrt(variance));
        }

        /// <summary>Mean render time at the lowest third of the loads, ms.</summary>
        public double LowMs { get; }

        public double HighMs { get; }

        /// <summary>Mean number of vertices of the lowest third of the loads.</summary>
        public double LowVertices { get; }

        public double HighVertices { get; }

        public double RiseMs => HighMs - LowMs;

        /// <summary>Minimum significant rise, ms.</summary>
        public double NeededMs { get; }

        /// <summary>
        /// Splits visits into passes of one direction. A change with time instead of load appears as a rise in only one direction. If the sweep
        /// has only one direction, the drift at constant load is subtracted. Loads without such an order form one pass. The result is empty for
        /// fewer than three different loads.
        /// </summary>
        public static List<SweepPass> Of(IReadOnlyList<SweepVisit> visits)
        {
            var ways = Ways(visits).Where(IsEnough).ToList();
            if (ways.Count == 0 && IsEnough(visits)) ways.Add(visits.ToList());
            var isUpAndDown = ways.Any(IsUp) && !ways.All(IsUp);
            return ways.ConvertAll(way => isUpAndDown ? new SweepPass(way, SweepDrift.None) : WithoutDrift(way, SweepDrift.Of(visits)));
        }

        // A short sweep measures drift inaccurately, and its drift is far smaller than a clear rise.
        static SweepPass WithoutDrift(IReadOnlyList<SweepVisit> way, SweepDrift drift)
        {
            var asIs = new SweepPass(way, SweepDrift.None);
            var isPlain = asIs.RiseMs >= Math.Max(asIs.NeededMs, PlainRise * Math.Abs(asIs.LowMs));
            return isPlain && Certainty * drift.Error > asIs.RiseMs / 2 ? asIs : new SweepPass(way, drift);
        }

        static bool IsEnough(IReadOnlyList<SweepVisit> visits) => visits.Select(visit => visit.Vertices).Distinct().Count() >= MinLoads;

        /// <summary>Splits visits into runs of one direction. A load at which the direction changes belongs to both runs.</summary>
        static IEnumerable<List<SweepVisit>> Ways(IReadOnlyList<SweepVisit> visits)
        {
            var way = new List<SweepVisit>();
            foreach (var visit in visits)
            {
                if (way.Count >= 2 && visit.Vertices > way[way.Count - 1].Vertices != IsUp(way))
                {
                    yield return way;
                    way = new List<SweepVisit> { way[way.Count - 1] };
                }
                way.Add(visit);
            }
            yield return way;
        }

        static bool IsUp(IReadOnlyList<SweepVisit> way) => way[1].Vertices > way[0].Vertices;
    }
}
