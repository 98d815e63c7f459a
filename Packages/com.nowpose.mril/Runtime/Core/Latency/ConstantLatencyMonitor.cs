using System;

namespace Nowpose.Latency
{
    /// <summary>Reason why a <see cref="RangeState"/> is unknown.</summary>
    enum RangeUnknownReason
    {
        /// <summary>The state is known.</summary>
        None,

        /// <summary>Neither the settings nor a calibration contain a limit.</summary>
        NoLimit,

        /// <summary>The render time is not measured.</summary>
        NoRenderTime,

        /// <summary>Too few frames were measured with the current source.</summary>
        TooFewFrames,

        /// <summary>The limit was found with another source of the render time and does not apply to the current source.</summary>
        OtherSource,

        /// <summary>The render time is beyond the calibrated range, and the calibration found no limit in it.</summary>
        BeyondMeasured,

        /// <summary>No range is known, and the display's GPU time is above its refresh interval, so frames miss refreshes.</summary>
        LongerThanRefresh,
    }

    /// <summary>Whether the render time is in the constant-latency range, so that L_visu has its calibrated value.</summary>
    /// <remarks>Schnierle &amp; Röck 2022, Fig. 11b.</remarks>
    public enum RangeState
    {
        /// <summary>
        /// The state cannot be determined; <see cref="RangeUnknownReason"/> gives the reason. The calibrated L_visu is used, and the pose counts as
        /// current.
        /// </summary>
        Unknown,

        /// <summary>L_visu is constant.</summary>
        Inside,

        /// <summary>Frames miss the display's refresh: L_visu is longer than calibrated, by an unknown amount.</summary>
        Outside,
    }

    /// <summary>Detects, frame by frame, whether the render time is in the constant-latency range.</summary>
    /// <remarks>
    /// Schnierle &amp; Röck 2022, Fig. 11b. Uses the median of the newest 15 frames, so that one slow frame has no effect. A sudden load
    /// that raises the render time to 10 % or more above the limit is detected within 10 frames. A load slightly above the limit takes
    /// longer, because some of its frames are below the limit. Allocates nothing; not thread-safe.
    /// </remarks>
    sealed class ConstantLatencyMonitor
    {
        const int Window = 15;
        const int FramesToJudge = 8;

        /// <summary>
        /// Hysteresis of the state. The state becomes <see cref="RangeState.Inside"/> again when the median has stayed below ClearlyInside times the
        /// limit for <see cref="FramesToReturn"/> frames.
        /// </summary>
        internal const double ClearlyInside = 0.94;
        const int FramesToReturn = 30;

        readonly RollingPercentiles _recent = new RollingPercentiles(Window);
        ConstantLatencyRange _range;
        bool? _isBeyond;
        int _clearFrames;

        /// <param name="range">Initial value of <see cref="Range"/>.</param>
        public ConstantLatencyMonitor(ConstantLatencyRange range) => _range = range;

        /// <summary>Range to monitor. If it is null, no range is known, and the state stays unknown. A change applies from the next frame.</summary>
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

        /// <summary>
        /// Time between two refreshes of the display; null if unknown. Without a range, it is the limit of
        /// <see cref="RenderTimeSourceKind.DisplayGpuTime"/>: beyond it, L_visu is certainly longer. Other sources include waiting times.
        /// </summary>
        public TimeSpan? RefreshInterval { get; set; }

        public RangeState State
        {
            get
            {
                if (_range == null || _isBeyond == null) return RangeState.Unknown;
                if (_isBeyond == false) return RangeState.Inside;
                return _range.IsLimitReached ? RangeState.Outside : RangeState.Unknown;
            }
        }

        /// <summary>Reason why <see cref="State"/> is unknown.</summary>
        public RangeUnknownReason UnknownReason
        {
            get
            {
                if (State != RangeState.Unknown) return RangeUnknownReason.None;
                if (_range == null) return _isBeyond == true ? RangeUnknownReason.LongerThanRefresh : RangeUnknownReason.NoLimit;
                if (Source == RenderTimeSourceKind.None) return RangeUnknownReason.NoRenderTime;
                if (Source != _range.Source) return RangeUnknownReason.OtherSource;
                return _isBeyond == true ? RangeUnknownReason.BeyondMeasured : RangeUnknownReason.TooFewFrames;
            }
        }

        /// <summary>Source of the newest render time.</summary>
        public RenderTimeSourceKind Source { get; private set; }

        /// <summary>Median that is compared with the limit; null before the first measurement with the current source.</summary>
        public TimeSpan? RenderTime => _recent.Count == 0 ? (TimeSpan?)null : _recent.At(0.5);

        /// <summary>Adds the render time of one frame. A change of the source restarts the window.</summary>
        /// <param name="renderTime">
        /// Render time of the frame. Zero and negative values are ignored, because drivers that do not measure report zero.
        /// </param>
        /// <param name="source"><see cref="RenderTimeSourceKind.None"/> when the render time is no longer measured.</param>
        public void Add(TimeSpan renderTime, RenderTimeSourceKind source)
        {
            if (source != Source) Restart(source);
            if (source == RenderTimeSourceKind.None || renderTime <= TimeSpan.Zero) return;
            _recent.Add(renderTime);
            if (_recent.Count >= FramesToJudge && Limit is TimeSpan limit) Judge(_recent.At(0.5), limit);
        }

        // Limit that applies to the current source; null if there is none.
        TimeSpan? Limit
        {
            get
            {
                if (_range == null) return Source == RenderTimeSourceKind.DisplayGpuTime ? RefreshInterval : null;
                return _range.Source == Source ? _range.Limit : (TimeSpan?)null;
            }
        }

        void Restart(RenderTimeSourceKind source)
        {
            Source = source;
            _isBeyond = null;
            _recent.Reset();
            _clearFrames = 0;
        }

        void Judge(TimeSpan median, TimeSpan limit)
        {
            _clearFrames = median.Ticks < ClearlyInside * limit.Ticks ? _clearFrames + 1 : 0;
            if (median > limit) _isBeyond = true;
            else if (_isBeyond == null || _clearFrames >= FramesToReturn) _isBeyond = false;
        }
    }
}
