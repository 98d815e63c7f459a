using Nowpose.Messages;

namespace Nowpose.Latency.Sweep
{
    /// <summary>One frame of a load sweep: the load, and the render time that became known in the frame.</summary>
    readonly struct SweepRow
    {
        /// <param name="frameStart">Control time of the frame's start, which the timestamp code of the frame shows.</param>
        /// <param name="vertices">Number of vertices of the load that were drawn, 0 to <see cref="SweepPlan.MaxVertices"/>.</param>
        /// <param name="renderMs">Δt_render that became known in this frame, see <see cref="MeasuredRenderTime"/>; null if none became known.</param>
        /// <param name="source">Source of the render time; may also be set without a render time.</param>
        /// <param name="device">Device name as in a latency profile; empty when unknown.</param>
        /// <param name="displayHz">Display rate; NaN when unknown.</param>
        /// <exception cref="InputException">A value is out of range, or a render time has no source.</exception>
        public SweepRow(ControlTime frameStart, long vertices, double? renderMs, RenderTimeSourceKind source, string device, double displayHz)
        {
            Vertices = SettingRange.RequireCount(vertices, 0, SweepPlan.MaxVertices, "vertices");
            if (renderMs is double ms) RequireMeasured(ms, source);
            if (!double.IsNaN(displayHz)) SettingRange.Require(displayHz, 1, 1000, "display rate", "Hz");
            FrameStart = frameStart;
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
                throw new InputException(SweepMessages.TimeWithoutSource);
        }
    }
}
