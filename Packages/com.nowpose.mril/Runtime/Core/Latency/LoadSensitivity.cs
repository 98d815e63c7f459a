using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Nowpose.Latency.Sweep;

namespace Nowpose.Latency
{
    /// <summary>Result of the check whether the render time of a sweep depends on the load. If it does not, the sweep yields no limit.</summary>
    /// <remarks>
    /// Compares the lowest third of the loads with the highest third, separately for each pass through the loads; the pass with the
    /// smallest rise decides. If the sweep has only one direction, the drift at constant load is subtracted. Up to a tenth of the render
    /// times may be outliers.
    /// </remarks>
    public sealed class LoadSensitivity
    {
        /// <summary>Minimum number of render times of a load; loads with fewer are ignored.</summary>
        const int MinRenderTimes = 15;

        LoadSensitivity(LoadSight sight, RenderTimeSourceKind source, string words)
        {
            Sight = sight;
            Source = source;
            Words = words;
        }

        internal LoadSight Sight { get; }

        /// <summary>The source of most render times, to which the result applies; times of other sources are ignored.</summary>
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
                    "no component measured the render time, so the limit cannot be determined; see the manual's page Render Time Source");
            var visits = SweepVisit.Of(rows, source, MinRenderTimes);
            var passes = SweepPass.Of(visits);
            return passes.Count == 0 ? Unclear(source, visits) : Judge(source, passes);
        }

        static LoadSensitivity Judge(RenderTimeSourceKind source, List<SweepPass> passes)
        {
            var min = passes.OrderBy(pass => pass.RiseMs / pass.NeededMs).First();
            var name = RenderTimeSourceNames.NameOf(source);
            var rise = string.Format(
                CultureInfo.InvariantCulture, "from about {0:0} to {1:0} vertices {2} went from {3:0.00} to {4:0.00} ms",
                min.LowVertices, min.HighVertices, name, min.LowMs, min.HighMs);
            if (min.RiseMs >= min.NeededMs) return new LoadSensitivity(LoadSight.Seen, source, "this source responds to load: " + rise);
            return new LoadSensitivity(LoadSight.Unseen, source, string.Format(
                CultureInfo.InvariantCulture, "this source does not respond to load: {0}; the increase must be at least {1:0.00} ms; {2}",
                rise, min.NeededMs, Advice(source)));
        }

        static LoadSensitivity Unclear(RenderTimeSourceKind source, List<SweepVisit> visits)
        {
            var loads = visits.Select(visit => visit.Vertices).Distinct().Count();
            return new LoadSensitivity(LoadSight.Unclear, source, string.Format(
                CultureInfo.InvariantCulture,
                "too few data to determine whether {0} responds to load: {1} {2} {3} or more render times; 3 are needed; use more loads or a longer sweep",
                RenderTimeSourceNames.NameOf(source), loads, loads == 1 ? "load has" : "loads have", MinRenderTimes));
        }

        static string Advice(RenderTimeSourceKind source) => source == RenderTimeSourceKind.CameraCpu
            ? "it does not measure the GPU; switch on Frame Timing Stats in the player settings, or use a device that reports GPU times, and sweep again"
            : "keep the load in view, increase the maximum load, and sweep again";

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
