using System;

namespace Nowpose.Latency
{
    /// <summary>Reason why a <see cref="RangeState"/> is unknown, or outside at any render time.</summary>
    enum RangeUnknownReason
    {
        /// <summary>The render time determines the state.</summary>
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

        /// <summary>Outside, because frames start at less than two thirds of the display's refresh rate, so that they miss refreshes.</summary>
        LowFrameRate,
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

    /// <summary>Detects, frame by frame, whether the render time is in the constant-latency range, and whether frames miss refreshes.</summary>
    /// <remarks>
    /// Schnierle &amp; Röck 2022, Fig. 11b. Uses the median of the newest 15 frames, so that one slow frame has no effect. A sudden load
    /// that raises the render time to 10 % or more above the limit is detected within 10 frames. A load slightly above the limit takes
    /// longer, because some of its frames are below the limit. Allocates nothing; not thread-safe.
    /// </remarks>
    sealed class ConstantLatencyMonitor
    {
        /// <summary>Maximum time between two frames, in refresh intervals. At a lower frame rate, frames miss refreshes.</summary>
        const double MaxIntervals = 1.5;

        readonly MedianLimit _renderTimes = new MedianLimit(), _frameTimes = new MedianLimit();
        ConstantLatencyRange _range;
        HeadsetTime? _newestStart;

        /// <param name="range">Initial value of <see cref="Range"/>.</param>
        public ConstantLatencyMonitor(ConstantLatencyRange range) => _range = range;

        /// <summary>Range to monitor. If it is null, no range is known. A change applies from the next frame.</summary>
        public ConstantLatencyRange Range
        {
            get => _range;
            set
            {
                _range = value;
                _renderTimes.Forget();
            }
        }

        /// <summary>
        /// Time between two refreshes of the display; null if unknown. Without a range, it is the limit of
        /// <see cref="RenderTimeSourceKind.DisplayGpuTime"/>: beyond it, L_visu is certainly longer. Other sources include waiting times.
        /// </summary>
        public TimeSpan? RefreshInterval { get; set; }

        /// <summary>Whether frames miss refreshes. <see cref="State"/> is then outside at any render time.</summary>
        public bool MissesRefreshes => _frameTimes.IsBeyond == true;

        public RangeState State
        {
            get
            {
                if (MissesRefreshes) return RangeState.Outside;
                if (_range == null || _renderTimes.IsBeyond == null) return RangeState.Unknown;
                if (_renderTimes.IsBeyond == false) return RangeState.Inside;
                return _range.IsLimitReached ? RangeState.Outside : RangeState.Unknown;
            }
        }

        /// <summary>Reason why <see cref="State"/> is unknown, or outside at any render time.</summary>
        public RangeUnknownReason UnknownReason
        {
            get
            {
                if (MissesRefreshes) return RangeUnknownReason.LowFrameRate;
                if (State != RangeState.Unknown) return RangeUnknownReason.None;
                if (_range == null) return _renderTimes.IsBeyond == true ? RangeUnknownReason.LongerThanRefresh : RangeUnknownReason.NoLimit;
                if (Source == RenderTimeSourceKind.None) return RangeUnknownReason.NoRenderTime;
                if (Source != _range.Source) return RangeUnknownReason.OtherSource;
                return _renderTimes.IsBeyond == true ? RangeUnknownReason.BeyondMeasured : RangeUnknownReason.TooFewFrames;
            }
        }

        /// <summary>Source of the newest render time.</summary>
        public RenderTimeSourceKind Source { get; private set; }

        /// <summary>Median that is compared with the limit; null before the first measurement with the current source.</summary>
        public TimeSpan? RenderTime => _renderTimes.Median;

        /// <summary>Adds the start of a displayed frame. Its distance to the previous start is the time between two frames.</summary>
        public void AddStart(HeadsetTime start)
        {
            if (start - _newestStart is TimeSpan passed) _frameTimes.Add(passed, RefreshInterval * MaxIntervals);
            _newestStart = start;
        }

        /// <summary>Adds the render time of one frame. A change of the source restarts the window.</summary>
        /// <param name="renderTime">
        /// Render time of the frame. Zero and negative values are ignored, because drivers that do not measure report zero.
        /// </param>
        /// <param name="source"><see cref="RenderTimeSourceKind.None"/> when the render time is no longer measured.</param>
        public void Add(TimeSpan renderTime, RenderTimeSourceKind source)
        {
            if (source != Source) _renderTimes.Reset();
            Source = source;
            if (source != RenderTimeSourceKind.None && renderTime > TimeSpan.Zero) _renderTimes.Add(renderTime, Limit);
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
    }
}
