using System;
using Nowpose.Messages;

namespace Nowpose.Simulation
{
    /// <summary>
    /// Simulates a display with a GPU that renders frames in order. L_visu is constant up to a certain render time and scatters above it.
    /// </summary>
    /// <remarks>
    /// Models the effect of Schnierle &amp; Röck 2022, Figs 10 and 11. As long as frames take less than a refresh interval, each frame starts at a
    /// refresh. At most two frames are in progress: the next frame waits until the older frame is done. If frames take longer than a refresh
    /// interval, their start times therefore drift relative to the refreshes. A frame is displayed at the first refresh before whose deadline it is
    /// done. If two frames are done before the same refresh, only the newer frame is displayed. Render times grow with the load and scatter a little,
    /// and one frame in a hundred takes much longer. Seeded; allocates nothing after construction; not thread-safe.
    /// </remarks>
    sealed class DisplayPipeline
    {
        readonly DisplayPipelineSettings _settings;
        readonly Random _random;

        /// <summary>Number of the newest refresh at or before the next start.</summary>
        long _refresh;
        double _nextStartMs, _gpuFreeMs;

        /// <param name="settings">Settings of the display; null for the defaults.</param>
        public DisplayPipeline(int seed, DisplayPipelineSettings settings = null)
        {
            _settings = settings ?? new DisplayPipelineSettings();
            _random = new Random(seed);
        }

        /// <summary>Time from the pipeline's start to the start of the next frame.</summary>
        public TimeSpan NextStart => Span(_nextStartMs);

        /// <summary>Renders the next frame.</summary>
        /// <param name="vertices">The load in vertices, 0 or more.</param>
        public PipelineFrame Next(double vertices)
        {
            if (!(vertices >= 0 && vertices < 1e9))
                throw new ArgumentOutOfRangeException(nameof(vertices), vertices, SettingMessages.Vertices);
            var renderMs = (DisplayPipelineSettings.BaseMs + _settings.MsPerMillion * vertices / 1e6) * Slowness();
            var (startMs, olderDoneMs) = (_nextStartMs, _gpuFreeMs);
            _gpuFreeMs = Math.Max(olderDoneMs, startMs) + renderMs;
            WaitForRoom(olderDoneMs);
            var shown = (long)Math.Ceiling((_gpuFreeMs + DisplayPipelineSettings.LatchMs) / _settings.RefreshMs);
            var visualisationMs = (shown - 1) * _settings.RefreshMs - startMs + _settings.PlateauMs;
            return new PipelineFrame(Span(startMs), Span(renderMs), Span(_gpuFreeMs), Span(visualisationMs), shown);
        }

        // The next frame starts at the next refresh, but not before the older of the two frames in progress is done.
        void WaitForRoom(double olderDoneMs)
        {
            _refresh = Math.Max(_refresh + 1, (long)Math.Floor(olderDoneMs / _settings.RefreshMs));
            _nextStartMs = Math.Max(_refresh * _settings.RefreshMs, olderDoneMs);
        }

        double Slowness()
        {
            var normal = _random.NextNormal();
            var slowness = Math.Max(0.1, 1 + _settings.Scatter * normal);
            return _random.NextDouble() < _settings.SpikeChance ? slowness * (1.5 + _random.NextDouble()) : slowness;
        }

        static TimeSpan Span(double ms) => ClockTicks.Span(ms / 1000);
    }
}
