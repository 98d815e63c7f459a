using System;
using System.Collections.Generic;
using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using Nowpose.Simulation;

namespace Nowpose.Tests.Core.Latency.Sweep
{
    /// <summary>Simulates the rows of a sweep at 60 Hz, with a render time for each frame. The random numbers are seeded.</summary>
    sealed class SimulatedSweep
    {
        readonly SweepPlan _plan;
        readonly Random _random;
        readonly DisplayPipeline _gpu;

        public SimulatedSweep(SweepPlan plan, int seed)
        {
            _plan = plan;
            _random = new Random(seed);
            _gpu = new DisplayPipeline(seed);
        }

        public RenderTimeSourceKind Source { get; set; } = RenderTimeSourceKind.CameraCpu;

        /// <summary>Probability that a render time is an outlier. An outlier is 5 to 105 ms too long.</summary>
        public double Outliers { get; set; } = 0.02;

        /// <summary>Returns the GPU time in ms: 4 ms plus 8.5 ms per million vertices, with scatter.</summary>
        public double GpuMs(double seconds, int vertices) => _gpu.Next(vertices).RenderTime.TotalMilliseconds;

        /// <summary>Returns a random number of the standard normal distribution.</summary>
        public double Normal() => _random.NextNormal();

        /// <param name="renderMs">
        /// Function that returns the render time in ms, given the seconds since the sweep began and the number of vertices; null for a frame
        /// without a render time.
        /// </param>
        public List<SweepRow> Rows(Func<double, int, double?> renderMs)
        {
            var rows = new List<SweepRow>();
            var frames = (int)(60 * _plan.TimePerLoad.TotalSeconds);
            foreach (var load in _plan.Loads)
                for (var i = 0; i < frames; i++)
                {
                    var seconds = rows.Count / 60.0;
                    var ms = renderMs(seconds, load);
                    if (ms.HasValue && _random.NextDouble() < Outliers) ms += 5 + 100 * _random.NextDouble();
                    rows.Add(new SweepRow(ControlTime.FromSeconds(1000 + seconds), load, ms, Source, "simulated", 60));
                }
            return rows;
        }
    }
}
