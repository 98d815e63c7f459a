using System;

namespace Nowpose.Latency.DisplayTime
{
    /// <summary>Determines the display time of each frame: the runtime's prediction if available, else the calibrated L_visu.</summary>
    /// <remarks>Allocates nothing; not thread-safe.</remarks>
    sealed class DisplayTimeSelector
    {
        /// <summary>Time without a display time after which the results of the checks no longer apply.</summary>
        static readonly TimeSpan MaxSilence = TimeSpan.FromSeconds(1);

        readonly DisplayTimeCheck _check = new DisplayTimeCheck();
        readonly DisplayTimePlausibility _plausibility = new DisplayTimePlausibility();
        VisualisationLatency _calibrated;
        IDisplayTimeSource _source;
        HeadsetTime? _newest;

        public DisplayTimeSelector(VisualisationLatency calibrated, LatencyProfile profile)
        {
            _calibrated = calibrated;
            Profile = profile;
            Used = calibrated.Length;
        }

        /// <summary>The constant L_visu. Setting it clears <see cref="Profile"/>.</summary>
        public VisualisationLatency Calibrated
        {
            get => _calibrated;
            set => Calibrate(value, null);
        }

        /// <summary>Profile of the constant L_visu; null if the value was set as a number.</summary>
        public LatencyProfile Profile { get; private set; }

        /// <summary>Source of predicted display times; null to use the calibrated L_visu.</summary>
        public IDisplayTimeSource Source
        {
            get => _source;
            set
            {
                _source = value;
                IsPredicted = false;
                Used = _calibrated.Length;
                ResetChecks();
            }
        }

        /// <summary>L_visu of the newest frame.</summary>
        public TimeSpan Used { get; private set; }

        /// <summary>Whether <see cref="Used"/> comes from the source.</summary>
        public bool IsPredicted { get; private set; }

        /// <summary>Value of <see cref="DisplayTimeCheck.Difference"/>.</summary>
        public TimeSpan? Difference => _check.Difference;

        /// <summary>Value of <see cref="DisplayTimeCheck.IsInconsistent"/>.</summary>
        public bool IsInconsistent => _check.IsInconsistent;

        /// <summary>Value of <see cref="DisplayTimePlausibility.Ahead"/>.</summary>
        public TimeSpan? Ahead => _plausibility.Ahead;

        /// <summary>Value of <see cref="DisplayTimePlausibility.IsImplausible"/>.</summary>
        public bool IsImplausible => _plausibility.IsImplausible;

        /// <summary>Returns the display time of a frame.</summary>
        /// <param name="isComparable">
        /// False when a comparison with the calibration is not meaningful: the render time shows that L_visu differs from the calibrated
        /// value, or the frame will be computed again before it is rendered.
        /// </param>
        public HeadsetTime LightOf(HeadsetTime frameStart, bool isComparable)
        {
            var ahead = _source?.LightOf(frameStart) - frameStart;
            if (ahead.HasValue) _newest = frameStart;
            else if (frameStart - _newest > MaxSilence) ResetChecks();
            IsPredicted = ahead.HasValue && _plausibility.Add(frameStart, ahead.Value);
            Used = IsPredicted ? ahead.Value : _calibrated.Length;
            if (IsPredicted && isComparable) _check.Add(frameStart, ahead.Value - _calibrated.Length);
            return frameStart + Used;
        }

        /// <param name="profile">Profile that contains the value; null if the value was set as a number.</param>
        public void Calibrate(VisualisationLatency calibrated, LatencyProfile profile)
        {
            if (calibrated.Length != _calibrated.Length) _check.Reset();
            _calibrated = calibrated;
            Profile = profile;
            if (!IsPredicted) Used = calibrated.Length;
        }

        void ResetChecks()
        {
            _newest = null;
            _check.Reset();
            _plausibility.Reset();
        }
    }
}
