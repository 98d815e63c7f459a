using System;

namespace Nowpose.Latency.DisplayTime
{
    /// <summary>Finds a lasting difference between the display times that a runtime predicts and those that were calibrated.</summary>
    /// <remarks>
    /// Either the calibration is of something else (another mode of the display, an update of the runtime) or the prediction
    /// leaves something out. Single frames with a bad prediction are ignored. Allocates nothing; not thread-safe.
    /// </remarks>
    sealed class DisplayTimeCheck
    {
        /// <summary>A second at 60 Hz.</summary>
        const int Window = 60;

        static readonly TimeSpan Doubtful = TimeSpan.FromMilliseconds(5);

        /// <summary>At the very limit the doubt would come and go.</summary>
        static readonly TimeSpan Agreeing = TimeSpan.FromMilliseconds(4);

        static readonly TimeSpan Lasting = TimeSpan.FromSeconds(1);

        /// <summary>Longer without a frame, and nobody knows what the difference was meanwhile.</summary>
        static readonly TimeSpan Gap = TimeSpan.FromMilliseconds(250);

        readonly RollingPercentiles _recent = new RollingPercentiles(Window);
        HeadsetTime? _since, _newest;

        /// <summary>Whether the median has differed by more than 5 ms for a second, and not yet by less than 4 ms for another.</summary>
        /// <remarks>A second in which frames came: one that follows more than 0.25 s after the last begins it anew.</remarks>
        public bool IsDoubted { get; private set; }

        /// <summary>Median of predicted minus calibrated over the newest 60 frames, positive when light is predicted later; null before.</summary>
        public TimeSpan? Difference => _recent.Count < Window ? (TimeSpan?)null : _recent.At(0.5);

        /// <summary>Takes one frame for which both are known.</summary>
        /// <param name="frameStart">Not earlier than the one before.</param>
        public void Add(HeadsetTime frameStart, TimeSpan predictedMinusCalibrated)
        {
            if (frameStart - _newest > Gap) _since = null;
            _newest = frameStart;
            _recent.Add(predictedMinusCalibrated);
            if (!(Difference is TimeSpan median)) return;
            var isNews = IsDoubted ? median.Duration() < Agreeing : median.Duration() > Doubtful;
            if (!isNews) _since = null;
            else if (frameStart - (_since ??= frameStart) >= Lasting) Turn();
        }

        /// <summary>Forgets all: another calibration, or another source.</summary>
        public void Reset()
        {
            _recent.Reset();
            _since = null;
            _newest = null;
            IsDoubted = false;
        }

        void Turn()
        {
            IsDoubted = !IsDoubted;
            _since = null;
        }
    }
}
