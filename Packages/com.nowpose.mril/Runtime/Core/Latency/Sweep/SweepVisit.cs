using System.Collections.Generic;

namespace Nowpose.Latency.Sweep
{
    /// <summary>What was measured while a sweep showed one load without a break.</summary>
    sealed class SweepVisit
    {
        SweepVisit(int vertices, IReadOnlyList<double> seconds, IReadOnlyList<double> renderMs)
        {
            Vertices = vertices;
            var count = renderMs.Count;
            var third = count / 3;
            var all = new TrimmedMean(renderMs, 0, count);
            RenderMs = all.Mean;
            RenderError = all.Error;
            TrimmedMean first = new TrimmedMean(renderMs, 0, third), last = new TrimmedMean(renderMs, count - third, third);
            Middle = (seconds[0] + seconds[count - 1]) / 2;
            var between = 2.0 / 3 * (seconds[count - 1] - seconds[0]);
            Drift = (last.Mean - first.Mean) / between;
            DriftVariance = (last.Error * last.Error + first.Error * first.Error) / (between * between);
        }

        public int Vertices { get; }

        /// <summary>Milliseconds; outliers do not count.</summary>
        public double RenderMs { get; }

        /// <summary>Standard error of <see cref="RenderMs"/>.</summary>
        public double RenderError { get; }

        /// <summary>Seconds since the sweep began.</summary>
        public double Middle { get; }

        /// <summary>How fast the render time grew while the load stayed the same, ms/s.</summary>
        public double Drift { get; }

        /// <summary>Of <see cref="Drift"/>, (ms/s)².</summary>
        public double DriftVariance { get; }

        /// <summary>One after the other; those with too few render times are left out.</summary>
        /// <param name="rows">One or more.</param>
        /// <param name="source">Only times that were measured with it count.</param>
        /// <param name="fewest">Render times that a visit needs, 3 or more.</param>
        public static List<SweepVisit> Of(IReadOnlyList<SweepRow> rows, RenderTimeSourceKind source, int fewest)
        {
            var visits = new List<SweepVisit>();
            List<double> seconds = new List<double>(), renderMs = new List<double>();
            for (var i = 0; i < rows.Count; i++)
            {
                if (rows[i].Source == source && rows[i].RenderMs is double ms)
                {
                    seconds.Add(ClockTicks.Seconds(rows[i].FrameStart - rows[0].FrameStart));
                    renderMs.Add(ms);
                }
                if (i + 1 < rows.Count && rows[i + 1].Vertices == rows[i].Vertices) continue;
                // A clock that stepped back makes no time of its own.
                if (renderMs.Count >= fewest && seconds[seconds.Count - 1] > seconds[0])
                    visits.Add(new SweepVisit(rows[i].Vertices, seconds, renderMs));
                seconds.Clear();
                renderMs.Clear();
            }
            return visits;
        }
    }
}
