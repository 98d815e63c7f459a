using System.Collections.Generic;

namespace Nowpose.Latency.Sweep
{
    /// <summary>Render times measured while a sweep showed one load without interruption.</summary>
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
            Trend = (last.Mean - first.Mean) / between;
            TrendVariance = (last.Error * last.Error + first.Error * first.Error) / (between * between);
        }

        public int Vertices { get; }

        /// <summary>Trimmed mean of the render times, ms.</summary>
        public double RenderMs { get; }

        /// <summary>Standard error of <see cref="RenderMs"/>.</summary>
        public double RenderError { get; }

        /// <summary>Middle of the visit, in seconds since the start of the sweep.</summary>
        public double Middle { get; }

        /// <summary>Rate at which the render time grew at constant load, ms/s.</summary>
        public double Trend { get; }

        /// <summary>Variance of <see cref="Trend"/>, (ms/s)².</summary>
        public double TrendVariance { get; }

        /// <summary>Returns the visits in chronological order, without visits that have too few render times.</summary>
        /// <param name="rows">Rows of the sweep, one or more.</param>
        /// <param name="source">Source of the render times; times of other sources are ignored.</param>
        /// <param name="fewest">Minimum number of render times of a visit, 3 or more.</param>
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
                // A visit during which the clock stepped back has no valid duration.
                if (renderMs.Count >= fewest && seconds[seconds.Count - 1] > seconds[0])
                    visits.Add(new SweepVisit(rows[i].Vertices, seconds, renderMs));
                seconds.Clear();
                renderMs.Clear();
            }
            return visits;
        }
    }
}
