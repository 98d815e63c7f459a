using System;

namespace Nowpose.Latency
{
    /// <summary>Tells, frame after frame, whether the render time stands in the constant-latency range.</summary>
    /// <remarks>
    /// Schnierle &amp; Röck 2022, Fig. 11b. Judges the median of the newest 15 frames, so that one slow frame is no alarm;
    /// a load that is suddenly a tenth or more above the limit is found within 10 frames, one a little above it some frames later,
    /// as single frames of it are below. Allocates nothing; not thread-safe.
    /// </remarks>
    sealed class ConstantLatencyMonitor
    {
        const int Window = 15;
        const int FramesToJudge = 8;

        /// <summary>Back inside only when it is clear: at the very limit the state would change with every frame.</summary>
        const double ClearlyInside = 0.94;
        const int FramesToReturn = 30;

        readonly RollingPercentiles _recent = new RollingPercentiles(Window);
        ConstantLatencyRange _range;
        bool? _isBeyond;
        int _clearFrames;

        /// <param name="range">As <see cref="Range"/>.</param>
        public ConstantLatencyMonitor(ConstantLatencyRange range) => _range = range;

        /// <summary>Null when none is known: the state stays unknown then. Another one is judged by from the next frame on.</summary>
        public ConstantLatencyRange Range
        {
            get => _range;
            set
            {
                _range = value;
                _isBeyond = null;
                _clearFrames = 0;
            }
        }

        public RangeState State
        {
            get
            {
                if (_isBeyond == false) return RangeState.Inside;
                return _isBeyond == true && _range.IsLimitReached ? RangeState.Outside : RangeState.Unknown;
            }
        }

        /// <summary>Why <see cref="State"/> is unknown.</summary>
        public RangeDoubt Doubt
        {
            get
            {
                if (State != RangeState.Unknown) return RangeDoubt.None;
                if (_range == null) return RangeDoubt.NoLimit;
                if (Source == RenderTimeSourceKind.None) return RangeDoubt.NoRenderTime;
                if (Source != _range.Source) return RangeDoubt.OtherSource;
                return _isBeyond == true ? RangeDoubt.BeyondMeasured : RangeDoubt.TooFewFrames;
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
            _isBeyond = null;
            _recent.Reset();
            _clearFrames = 0;
        }

        void Judge(TimeSpan median)
        {
            _clearFrames = median.Ticks < ClearlyInside * _range.Limit.Ticks ? _clearFrames + 1 : 0;
            if (median > _range.Limit) _isBeyond = true;
            else if (_isBeyond == null || _clearFrames >= FramesToReturn) _isBeyond = false;
        }
    }
}
