using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using Nowpose.Session;

namespace Nowpose.Unity.Calibration
{
    /// <summary>
    /// Data of one frame, which a sweep keeps until the next frame. If a frame is computed twice, the data of the second computation replace those of
    /// the first.
    /// </summary>
    readonly struct SweepFrame
    {
        readonly double? _renderMs;
        readonly RenderTimeSourceKind _source;
        readonly int _vertices;

        /// <param name="run">The sweep's state during the frame.</param>
        public SweepFrame(MrilSession session, DisplayFrame frame, SweepRun run, LoadGenerator load, RenderTimeSource renderTime)
        {
            Start = frame.Start;
            Control = FrameControlTime.Of(session, frame);
            IsShown = load.IsReady && load.Vertices == run.Vertices;
            _vertices = load.VerticesShown;
            _renderMs = renderTime.RenderTime?.TotalMilliseconds is double ms && MeasuredRenderTime.Is(ms) ? ms : (double?)null;
            _source = renderTime.Source;
        }

        public HeadsetTime Start { get; }

        /// <summary>Start of the frame in control time; null while the clock is not synchronised.</summary>
        public ControlTime? Control { get; }

        /// <summary>Whether the complete load of the current step was shown.</summary>
        public bool IsShown { get; }

        /// <summary>Whether the sweep uses this frame: its load is shown and its control time is known.</summary>
        public bool IsReady => IsShown && Control.HasValue;

        /// <summary>Creates the row of this frame for the log. <see cref="Control"/> must not be null.</summary>
        public SweepRow ToRow(string device, double displayHz) => new SweepRow(Control.Value, _vertices, _renderMs, _source, device, displayHz);
    }
}
