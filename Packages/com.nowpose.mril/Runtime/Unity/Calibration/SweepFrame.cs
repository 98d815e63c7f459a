using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using Nowpose.Session;

namespace Nowpose.Unity.Calibration
{
    /// <summary>The data of a frame that a sweep keeps until the next frame. If a frame is computed twice, only the second is shown.</summary>
    readonly struct SweepFrame
    {
        readonly double? _renderMs;
        readonly RenderTimeSourceKind _source;
        readonly int _vertices;

        /// <param name="run">The sweep's state while the frame is shown.</param>
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

        /// <summary>The start on the control clock; null while the clock is not synchronised.</summary>
        public ControlTime? Control { get; }

        /// <summary>Whether the load was complete.</summary>
        public bool IsShown { get; }

        /// <summary>Whether the frame counts for its load.</summary>
        public bool IsReady => IsShown && Control.HasValue;

        /// <summary>Makes the frame's row of the log; requires that <see cref="Control"/> is known.</summary>
        public SweepRow ToRow(string device, double displayHz) => new SweepRow(Control.Value, _vertices, _renderMs, _source, device, displayHz);
    }
}
