using System;

namespace Nowpose.Latency.Sweep
{
    /// <summary>One frame of a load sweep: which load it showed, and the render time that was known in it.</summary>
    readonly struct SweepRow
    {
        /// <param name="frameStart">Control time at which the frame began: the one that its timestamp code shows.</param>
        /// <param name="vertices">Vertices of the load that were drawn, 0 to <see cref="SweepPlan.GreatestVertices"/>.</param>
        /// <param name="renderMs">Δt_render that became known in this frame, a <see cref="MeasuredRenderTime"/>; null when none did.</param>
        /// <param name="source">What the render time was measured with; may be known in frames without one.</param>
        /// <param name="device">As a latency profile names it; empty when unknown.</param>
        /// <param name="displayHz">NaN when unknown.</param>
        /// <exception cref="InputException">Out of range, or a render time without a source.</exception>
        public SweepRow(ControlTime frameStart, int vertices, double? renderMs, RenderTimeSourceKind source, string device, double displayHz)
        {
            SettingRange.RequireCount(vertices, 0, SweepPlan.GreatestVertices, "vertices");
            if (renderMs is double ms) RequireMeasured(ms, source);
            if (!double.IsNaN(displayHz)) SettingRange.Require(displayHz, 1, 1000, "display rate", "Hz");
            FrameStart = frameStart;
            Vertices = vertices;
            RenderMs = renderMs;
            Source = source;
            Device = device ?? "";
            DisplayHz = displayHz;
        }

        public ControlTime FrameStart { get; }

        public int Vertices { get; }

        public double? RenderMs { get; }

        public RenderTimeSourceKind Source { get; }

        public string Device { get; }

        public double DisplayHz { get; }

        static void RequireMeasured(double ms, RenderTimeSourceKind source)
        {
            MeasuredRenderTime.RequireMs(ms);
            if (source == RenderTimeSourceKind.None)
                throw new InputException("render_ms: its source is missing; without it the time means nothing");
        }
    }
}
