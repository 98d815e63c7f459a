using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Latency.Sweep;
using Nowpose.Messages;

namespace Nowpose.Latency
{
    /// <summary>Result of the check whether the render time of a sweep depends on the load. If it does not, the sweep yields no limit.</summary>
    /// <remarks>
    /// Compares the lowest third of the loads with the highest third, separately for each pass through the loads; the result is that of the pass
    /// with the smallest rise relative to its minimum significant rise. If the sweep has only one direction, the trend at constant load is
    /// subtracted. Up to a tenth of the render times may be outliers.
    /// </remarks>
    public sealed class LoadSensitivity
    {
        /// <summary>Minimum number of render times of a load; loads with fewer are ignored.</summary>
        const int MinRenderTimes = 15;

        LoadSensitivity(LoadSight sight, RenderTimeSourceKind source, string words) => (Sight, Source, Words) = (sight, source, words);

        internal LoadSight Sight { get; }

        /// <summary>Source with the most render times. The result applies to this source; times of other sources are ignored.</summary>
        public RenderTimeSourceKind Source { get; }

        /// <summary>The result with its numbers in one line; includes the remedy if the render time does not depend on the load.</summary>
        public string Words { get; }

        /// <param name="rows">Rows of a whole sweep, in the order of their frames.</param>
        internal static LoadSensitivity Judge(IReadOnlyList<SweepRow> rows)
        {
            var source = SourceOf(rows);
            if (source == RenderTimeSourceKind.None)
                return new LoadSensitivity(
                    LoadSight.Unseen, source,
                    SweepMessages.NotMeasured);
            var visits = SweepVisit.Of(rows, source, MinRenderTimes);
            var passes = SweepPass.Of(visits);
            return passes.Count == 0 ? Unclear(source, visits) : Judge(source, passes);
        }

        static LoadSensitivity Judge(RenderTimeSourceKind source, List<SweepPass> passes)
        {
            var min = passes.OrderBy(pass => pass.RiseMs / pass.NeededMs).First();
            var name = LatencyNames.RenderTimeSource.NameOf(source);
            var rise = SweepMessages.Rise(min.LowVertices, min.HighVertices, name, min.LowMs, min.HighMs);
            if (min.RiseMs >= min.NeededMs) return new LoadSensitivity(LoadSight.Seen, source, SweepMessages.Responds(rise));
            return new LoadSensitivity(LoadSight.Unseen, source, SweepMessages.NoResponse(rise, min.NeededMs, Advice(source)));
        }

        static LoadSensitivity Unclear(RenderTimeSourceKind source, List<SweepVisit> visits)
        {
            var loads = visits.Select(visit => visit.Vertices).Distinct().Count();
            return new LoadSensitivity(
                LoadSight.Unclear, source, SweepMessages.TooFewData(LatencyNames.RenderTimeSource.NameOf(source), loads, MinRenderTimes));
        }

        static string Advice(RenderTimeSourceKind source) => source == RenderTimeSourceKind.CameraCpu
            ? SweepMessages.MeasureGpu
            : SweepMessages.IncreaseLoad;

        static RenderTimeSourceKind SourceOf(IReadOnlyList<SweepRow> rows)
        {
            var counts = new int[Enum.GetValues(typeof(RenderTimeSourceKind)).Length];
            foreach (var row in rows)
                if (row.RenderMs.HasValue) counts[(int)row.Source]++;
            var most = Array.IndexOf(counts, counts.Max());
            return counts[most] == 0 ? RenderTimeSourceKind.None : (RenderTimeSourceKind)most;
        }
    }
}
