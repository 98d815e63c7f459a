using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using Nowpose.Session;

namespace Nowpose.Unity.Calibration
{
    /// <summary>What a sweep keeps of a frame until it has gone: computed twice, only the second time is seen.</summary>
    readonly struct SweepFrame
    {
        readonly double? _renderMs;
        readonly RenderTimeSourceKind _source;
        readonly int _vertices;

        /// <param name="run">As it stands while the frame is shown.</param>
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

        /// <summary>The same on the control clock; null while it is not synchronised.</summary>
        public ControlTime? Control { get; }

        /// <summary>Whether the load was there in full.</summary>
        public bool IsShown { get; }

        /// <summary>Whether it counts for its load.</summary>
        public bool IsReady => IsShown && Control.HasValue;

        /// <summary>Where <see cref="Control"/> is known.</summary>
        public SweepRow ToRow(string device, double displayHz) => new SweepRow(Control.Value, _vertices, _renderMs, _source, device, displayHz);
    }
}
