using System;

namespace Nowpose.Simulation
{
    /// <summary>A display with a GPU that renders frames in order, so that L_visu is constant up to a render time and increases above it.</summary>
    /// <remarks>
    /// Models the effect of Schnierle &amp; Röck 2022, Figs 10 and 11. A frame is triggered at a refresh and displayed at the first refresh
    /// for which it is done before the latch. Two frames may be in progress; then the program waits for the older one, so frames that
    /// take longer than a refresh queue up. Render times grow with the load and scatter a little, and one frame in a hundred is
    /// much slower. Seeded; allocates nothing after construction; not thread-safe.
    /// </remarks>
    sealed class DisplayPipeline
    {
        readonly DisplayPipelineSettings _settings;
        readonly Random _random;
        long _nextTrigger;
        double _gpuFreeMs, _doneBeforeMs;

        /// <param name="settings">Null for the defaults.</param>
        public DisplayPipeline(int seed, DisplayPipelineSettings settings = null)
        {
            _settings = settings ?? new DisplayPipelineSettings();
            _random = new Random(seed);
        }

        /// <summary>Maximum constant render time at which L_visu does not increase.</summary>
        public TimeSpan TrueLimit => Span(_settings.RefreshMs - _settings.LatchMs);

        /// <summary>Start of the next frame, since the pipeline's start.</summary>
        public TimeSpan NextStart => Span(_nextTrigger * _settings.RefreshMs);

        /// <summary>Renders the next frame.</summary>
        /// <param name="vertices">The load in vertices, 0 or more.</param>
        public PipelineFrame Next(double vertices)
        {
            if (!(vertices >= 0 && vertices < 1e9))
                throw new ArgumentOutOfRangeException(nameof(vertices), vertices, "a frame has 0 to a billion vertices");
            var renderMs = (_settings.BaseMs + _settings.MsPerMillion * vertices / 1e6) * Slowness();
            var trigger = _nextTrigger;
            var startMs = trigger * _settings.RefreshMs;
            _doneBeforeMs = _gpuFreeMs;
            _gpuFreeMs = Math.Max(_gpuFreeMs, startMs) + renderMs;
            _nextTrigger = Math.Max(trigger + 1, RefreshAfter(_doneBeforeMs));
            var shownMs = RefreshAfter(_gpuFreeMs + _settings.LatchMs) * _settings.RefreshMs;
            return new PipelineFrame(
                Span(startMs), Span(renderMs), Span(_gpuFreeMs), Span(shownMs - startMs - _settings.RefreshMs + _settings.PlateauMs));
        }

        long RefreshAfter(double ms) => (long)Math.Ceiling(ms / _settings.RefreshMs);

        double Slowness()
        {
            var normal = Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())) * Math.Cos(2 * Math.PI * _random.NextDouble());
            var slowness = Math.Max(0.1, 1 + _settings.Scatter * normal);
            return _random.NextDouble() < _settings.SpikeChance ? slowness * (1.5 + _random.NextDouble()) : slowness;
        }

        static TimeSpan Span(double ms) => ClockTicks.Span(ms / 1000);
    }
}
