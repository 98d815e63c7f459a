using System;
using Nowpose.Latency;

namespace Nowpose.Session
{
    /// <summary>Adds a manual offset to a session's calibrated L_visu, for a user who sees that the displayed robot lags or leads.</summary>
    /// <remarks>
    /// While the offset is not zero, the session has no profile, because the resulting L_visu was not measured; at zero, its profile is
    /// restored. Another calibration resets the offset; a new session with the same calibration keeps it. Not thread-safe; allocates
    /// nothing.
    /// </remarks>
    sealed class VisualisationNudge
    {
        /// <summary>Maximum offset, larger than the error of a calibration; a larger offset requires a new calibration.</summary>
        public const double MaxMs = 50;

        static readonly double MaxVisuMs = LatencyProfile.MaxVisuMs;

        CompensationSession _session;
        VisualisationLatency _calibrated;
        LatencyProfile _profile;
        TimeSpan _applied;
        double _ms;
        bool _hasBegun;

        /// <summary>
        /// The offset, ms; positive predicts further ahead. Limited to ±<see cref="MaxMs"/> and to the valid range of L_visu. NaN
        /// becomes 0.
        /// </summary>
        public double Ms
        {
            get => _ms;
            set
            {
                _ms = Clamp(value);
                if (_session != null) Apply();
            }
        }

        /// <summary>Whether the runtime predicts the display time of each frame, so that the offset has no visible effect.</summary>
        public bool IsIdle => _session != null && _session.IsLightPredicted;

        /// <summary>Applies the offset to a new session, and detects a new calibration. Call it once per frame.</summary>
        /// <param name="session">The running session; null if there is none. The offset then applies to the next session.</param>
        public void Follow(CompensationSession session)
        {
            var isApplied = session == _session && (session == null || IsUnchanged);
            _session = session;
            if (session == null || isApplied) return;
            var isKnown = _hasBegun && session.Visualisation.Length == _calibrated.Length;
            _calibrated = session.Visualisation;
            _profile = session.Profile;
            // An offset that was chosen for another L_visu is not valid for this L_visu.
            if (_hasBegun && !isKnown) _ms = 0;
            _ms = Clamp(_ms);
            _hasBegun = true;
            Apply();
        }

        bool IsUnchanged => _session.Visualisation.Length == _applied && _session.Profile == (_ms == 0 ? _profile : null);

        void Apply()
        {
            if (_ms != 0) _session.Visualisation = VisualisationLatency.FromMilliseconds(_calibrated.Length.TotalMilliseconds + _ms);
            else if (!IsCalibrated) RestoreCalibration();
            _applied = _session.Visualisation.Length;
        }

        bool IsCalibrated => _session.Visualisation.Length == _calibrated.Length && _session.Profile == _profile;

        void RestoreCalibration()
        {
            if (_profile != null) _session.Calibrate(_profile);
            else _session.Visualisation = _calibrated;
        }

        double Clamp(double ms)
        {
            if (double.IsNaN(ms)) return 0;
            var kept = Math.Max(-MaxMs, Math.Min(MaxMs, ms));
            if (!_hasBegun) return kept;
            var calibrated = _calibrated.Length.TotalMilliseconds;
            return Math.Max(-calibrated, Math.Min(MaxVisuMs - calibrated, kept));
        }
    }
}
