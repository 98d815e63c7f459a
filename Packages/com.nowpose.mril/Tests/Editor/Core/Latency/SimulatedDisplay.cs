using System;

namespace Nowpose.Tests
{
    /// <summary>
    /// A 60 Hz display behind a GPU that works frames off in order: what is done 1.5 ms before a refresh is seen at it. Render
    /// times grow with the load, scatter a little, and one frame in a hundred is much slower. Milliseconds.
    /// </summary>
    sealed class SimulatedDisplay
    {
        public const double RefreshMs = 1000 / 60.0;
        const double LatchMs = 1.5;

        /// <summary>Render times up to here leave L_visu as it is.</summary>
        public const double TrueLimitMs = RefreshMs - LatchMs;

        readonly Random _random;
        long _trigger;
        double _gpuFree, _doneBefore;

        public SimulatedDisplay(int seed) => _random = new Random(seed);

        /// <summary>Relative standard deviation of the render times.</summary>
        public double Scatter { get; set; } = 0.03;

        public double SpikeChance { get; set; } = 0.01;

        /// <summary>Vertices, millions, that take this long to render.</summary>
        public static double LoadOf(double renderMs) => (renderMs - 4) / 8.5;

        /// <summary>Renders the next frame.</summary>
        public (double RenderMs, double VisualisationMs) Next(double millionVertices)
        {
            var render = (4 + 8.5 * millionVertices) * Slowness();
            // Two frames may be under way; then the program waits for the older one.
            _trigger = Math.Max(_trigger + 1, (long)Math.Ceiling(_doneBefore / RefreshMs));
            _doneBefore = _gpuFree;
            _gpuFree = Math.Max(_gpuFree, _trigger * RefreshMs) + render;
            var shown = (long)Math.Ceiling((_gpuFree + LatchMs) / RefreshMs);
            return (render, (shown - _trigger) * RefreshMs);
        }

        double Slowness()
        {
            var normal = Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())) * Math.Cos(2 * Math.PI * _random.NextDouble());
            return (1 + Scatter * normal) * (_random.NextDouble() < SpikeChance ? 1.5 + _random.NextDouble() : 1);
        }
    }
}
