using System;

namespace Nowpose.Latency
{
    /// <summary>Tells, frame after frame, whether the render time stands in the constant-latency range.</summary>
    /// <remarks>
    /// Schnierle &amp; Röck 2022, Fig. 11b. Judges the median of the newest 15 frames, so that one slow frame is no alarm;
    /// a load that is suddenly too high is found within 10 frames. Allocates nothing; not thread-safe.
    /// </remarks>
    public sealed class ConstantLatencyMonitor
    {
        const int Window = 15;
        const int FramesToJudge = 8;

        /// <summary>Back inside only when it is clear: at the very limit the state would change with every frame.</summary>
        const double ClearlyInside = 0.94;
        const int FramesToReturn = 30;

        readonly ConstantLatencyRange _range;
        readonly RollingPercentiles _recent = new RollingPercentiles(Window);
        int _clearFrames;

        /// <param name="range">Null when none is known: the state stays unknown then.</param>
        public ConstantLatencyMonitor(ConstantLatencyRange range) => _range = range;

        public RangeState State { get; private set; }

        /// <summary>Why <see cref="State"/> is unknown.</summary>
        public RangeDoubt Doubt
        {
            get
            {
                if (State != RangeState.Unknown) return RangeDoubt.None;
                if (_range == null) return RangeDoubt.NoLimit;
                if (Source == RenderTimeSourceKind.None) return RangeDoubt.NoRenderTime;
                return Source == _range.Source ? RangeDoubt.TooFewFrames : RangeDoubt.OtherSource;
            }
        }

        /// <summary>What the newest render time was measured with.</summary>
        public RenderTimeSourceKind Source { get; private set; }

        /// <summary>The median that is judged; null while nothing measures.</summary>
        public TimeSpan? RenderTime => _recent.Count == 0 ? (TimeSpan?)null : _recent.At(0.5);

        /// <summary>Takes the render time of one frame. Another source than the last frame's starts anew.</summary>
        /// <param name="renderTime">Zero or less is no measurement and is ignored: drivers that do not measure report zero.</param>
        /// <param name="source"><see cref="RenderTimeSourceKind.None"/> when nothing measures any more.</param>
        public void Add(TimeSpan renderTime, RenderTimeSourceKind source)
        {
            if (source != Source) StartAnew(source);
            if (source == RenderTimeSourceKind.None || renderTime <= TimeSpan.Zero) return;
            _recent.Add(renderTime);
            if (_range != null && _range.Source == source && _recent.Count >= FramesToJudge) Judge(_recent.At(0.5));
        }

        void StartAnew(RenderTimeSourceKind source)
        {
            Source = source;
            State = RangeState.Unknown;
            _recent.Reset();
            _clearFrames = 0;
        }

        void Judge(TimeSpan median)
        {
            _clearFrames = median.Ticks < ClearlyInside * _range.Limit.Ticks ? _clearFrames + 1 : 0;
            if (median > _range.Limit) State = RangeState.Outside;
            else if (State == RangeState.Unknown || _clearFrames >= FramesToReturn) State = RangeState.Inside;
        }
    }
}
