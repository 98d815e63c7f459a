using System;

namespace Nowpose.Latency.DisplayTime
{
    /// <summary>When the light of each frame appears: as the runtime predicts it where it does, else as calibrated.</summary>
    /// <remarks>Allocates nothing; not thread-safe.</remarks>
    sealed class MomentOfLight
    {
        readonly DisplayTimeCheck _check = new DisplayTimeCheck();
        readonly DisplayTimePlausibility _plausibility = new DisplayTimePlausibility();
        VisualisationLatency _calibrated;
        IDisplayTimeSource _source;

        public MomentOfLight(VisualisationLatency calibrated, LatencyProfile profile)
        {
            _calibrated = calibrated;
            Profile = profile;
            Used = calibrated.Length;
        }

        /// <summary>The constant L_visu. Setting it says that it comes from no profile.</summary>
        public VisualisationLatency Calibrated
        {
            get => _calibrated;
            set => Calibrate(value, null);
        }

        /// <summary>What the constant comes from; null when it was told as a number.</summary>
        public LatencyProfile Profile { get; private set; }

        /// <summary>Null for none: light appears as calibrated.</summary>
        public IDisplayTimeSource Source
        {
            get => _source;
            set
            {
                _source = value;
                IsPredicted = false;
                Used = _calibrated.Length;
                _check.Reset();
                _plausibility.Reset();
            }
        }

        /// <summary>L_visu of the newest frame.</summary>
        public TimeSpan Used { get; private set; }

        /// <summary>Whether the source gave it.</summary>
        public bool IsPredicted { get; private set; }

        /// <summary>As of <see cref="DisplayTimeCheck"/>.</summary>
        public TimeSpan? Difference => _check.Difference;

        /// <inheritdoc cref="Difference"/>
        public bool IsDoubted => _check.IsDoubted;

        /// <summary>As of <see cref="DisplayTimePlausibility"/>.</summary>
        public TimeSpan? Ahead => _plausibility.Ahead;

        /// <inheritdoc cref="Ahead"/>
        public bool IsImplausible => _plausibility.IsImplausible;

        /// <param name="isComparable">
        /// False where the render time says that L_visu is not the calibrated one, or where the frame is computed once more: nothing to
        /// compare with.
        /// </param>
        public HeadsetTime LightOf(HeadsetTime frameStart, bool isComparable)
        {
            var ahead = _source?.LightOf(frameStart) - frameStart;
            IsPredicted = ahead.HasValue && _plausibility.Add(frameStart, ahead.Value);
            Used = IsPredicted ? ahead.Value : _calibrated.Length;
            if (IsPredicted && isComparable) _check.Add(frameStart, ahead.Value - _calibrated.Length);
            return frameStart + Used;
        }

        /// <param name="profile">What it comes from; null when it was told as a number.</param>
        public void Calibrate(VisualisationLatency calibrated, LatencyProfile profile)
        {
            if (calibrated.Length != _calibrated.Length) _check.Reset();
            _calibrated = calibrated;
            Profile = profile;
            if (!IsPredicted) Used = calibrated.Length;
        }
    }
}
