using System;
using System.Collections.Generic;
using System.Linq;

namespace Nowpose.Latency.Sweep
{
    /// <summary>Some visits of a sweep, and how much the render time rises from their low loads to their high ones.</summary>
    sealed class SweepPass
    {
        const int FewestLoads = 3;

        /// <summary>Standard errors that a rise must exceed, to be no chance.</summary>
        const double Certainty = 4;

        /// <summary>Of the render time at low loads: a rise below it could not be told from one frame's scatter.</summary>
        const double LeastRise = 0.1;

        /// <summary>Of the render time at low loads: nothing drifts so far within a short sweep.</summary>
        const double PlainRise = 0.5;

        /// <param name="visits">In their order in time; three different loads or more.</param>
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
            NeededMs = Math.Max(LeastRise * Math.Abs(LowMs), Certainty * Math.Sqrt(variance));
        }

        /// <summary>Render time at the lowest and at the highest third of the loads, ms.</summary>
        public double LowMs { get; }

        public double HighMs { get; }

        /// <summary>Mean vertices of these loads.</summary>
        public double LowVertices { get; }

        public double HighVertices { get; }

        public double RiseMs => HighMs - LowMs;

        /// <summary>A rise from here on is one, ms.</summary>
        public double NeededMs { get; }

        /// <summary>
        /// Each way through the loads by itself, so that what changes with time and not by the load rises in one of them only; where
        /// they lead but one way, the drift that shows while a load stays is taken off. Loads in no such order are taken together.
        /// Empty for fewer than three different ones.
        /// </summary>
        public static List<SweepPass> Of(IReadOnlyList<SweepVisit> visits)
        {
            var ways = Ways(visits).Where(IsEnough).ToList();
            if (ways.Count == 0 && IsEnough(visits)) ways.Add(visits.ToList());
            var isUpAndDown = ways.Any(IsUp) && !ways.All(IsUp);
            return ways.ConvertAll(way => isUpAndDown ? new SweepPass(way, SweepDrift.None) : WithoutDrift(way, SweepDrift.Of(visits)));
        }

        // A short sweep cannot tell drift, and has no time to drift as far as a load that is seen.
        static SweepPass WithoutDrift(IReadOnlyList<SweepVisit> way, SweepDrift drift)
        {
            var asIs = new SweepPass(way, SweepDrift.None);
            var isPlain = asIs.RiseMs >= Math.Max(asIs.NeededMs, PlainRise * Math.Abs(asIs.LowMs));
            return isPlain && Certainty * drift.Error > asIs.RiseMs / 2 ? asIs : new SweepPass(way, drift);
        }

        static bool IsEnough(IReadOnlyList<SweepVisit> visits) => visits.Select(visit => visit.Vertices).Distinct().Count() >= FewestLoads;

        /// <summary>A load at which they turn belongs to both ways.</summary>
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
