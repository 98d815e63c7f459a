using System;

namespace Nowpose.Latency.DisplayTime
{
    /// <summary>Detects a lasting difference between the display times that a runtime predicts and the calibrated display times.</summary>
    /// <remarks>
    /// Such a difference means that either the calibration is for other conditions (another mode of the display, another version of the runtime) or
    /// the prediction is incomplete. Individual frames with a wrong prediction are ignored. Allocates nothing; not thread-safe.
    /// </remarks>
    sealed class DisplayTimeCheck
    {
        /// <summary>Window length in frames: one second at 60 Hz.</summary>
        const int Window = 60;

        static readonly TimeSpan MaxDifference = TimeSpan.FromMilliseconds(5);

        /// <summary>Hysteresis: the difference must fall below this value before the times count as consistent again.</summary>
        static readonly TimeSpan ConsistentBelow = TimeSpan.FromMilliseconds(4);

        static readonly TimeSpan Lasting = TimeSpan.FromSeconds(1);

        /// <summary>
        /// Maximum interval between frames. A longer interval restarts the measured duration, because the difference within it is unknown.
        /// </summary>
        static readonly TimeSpan Gap = TimeSpan.FromMilliseconds(250);

        readonly RollingPercentiles _recent = new RollingPercentiles(Window);
        HeadsetTime? _since, _newest;

        /// <summary>Whether the median difference has exceeded 5 ms for a second and has not since been below 4 ms for a second.</summary>
        /// <remarks>An interval of more than 0.25 s between frames restarts the measurement of this second.</remarks>
        public bool IsInconsistent { get; private set; }

        /// <summary>
        /// Median of predicted minus calibrated display time over 60 frames, positive for a later prediction; null with fewer frames.
        /// </summary>
        public TimeSpan? Difference => _recent.Count < Window ? (TimeSpan?)null : _recent.At(0.5);

        /// <summary>Adds one frame for which both display times are known.</summary>
        /// <param name="frameStart">Start of the frame, not earlier than the start of the previous frame.</param>
        public void Add(HeadsetTime frameStart, TimeSpan predictedMinusCalibrated)
        {
            if (frameStart - _newest > Gap) _since = null;
            _newest = frameStart;
            _recent.Add(predictedMinusCalibrated);
            if (!(Difference is TimeSpan median)) return;
            var contradictsState = IsInconsistent ? median.Duration() < ConsistentBelow : median.Duration() > MaxDifference;
            if (!contradictsState) _since = null;
            else if (frameStart - (_since ??= frameStart) >= Lasting) Toggle();
        }

        /// <summary>Removes all frames. Call it when the calibration or the source changes.</summary>
        public void Reset()
        {
            _recent.Reset();
            _since = null;
            _newest = null;
            IsInconsistent = false;
        }

        void Toggle()
        {
            IsInconsistent = !IsInconsistent;
            _since = null;
        }
    }
}
