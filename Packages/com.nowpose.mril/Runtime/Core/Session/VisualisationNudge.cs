using System;
using Nowpose.Latency;

namespace Nowpose.Session
{
    /// <summary>Shifts a session's L_visu by hand, on top of what it is calibrated to: for an eye that sees the robot lag or lead.</summary>
    /// <remarks>
    /// While it is not zero the session says that its L_visu comes from no profile, for nobody measured it; at zero it has its
    /// profile again. Another calibration ends the nudge, a session that begins anew with the same one keeps it. Not
    /// thread-safe; allocates nothing.
    /// </remarks>
    sealed class VisualisationNudge
    {
        /// <summary>More than an error of a calibration: beyond, calibrate.</summary>
        public const double GreatestMs = 50;

        static readonly double LongestMs = LatencyProfile.GreatestVisuMs;

        CompensationSession _session;
        VisualisationLatency _calibrated;
        LatencyProfile _profile;
        TimeSpan _applied;
        double _ms;
        bool _hasBegun;

        /// <summary>
        /// What is added, ms; positive predicts further ahead. Kept to ±<see cref="GreatestMs"/>, and to what leaves L_visu in its
        /// range. What is no number is 0.
        /// </summary>
        public double Ms
        {
            get => _ms;
            set
            {
                _ms = Allowed(value);
                if (_session != null) Apply();
            }
        }

        /// <summary>Whether L_visu is predicted by the runtime, frame by frame: the nudge changes nothing that is seen then.</summary>
        public bool IsIdle => _session != null && _session.IsLightPredicted;

        /// <summary>Once a frame: nudges a session that has begun, and sees whether somebody calibrated it.</summary>
        /// <param name="session">Null while there is none: the nudge waits for the next.</param>
        public void Follow(CompensationSession session)
        {
            var isOurs = session == _session && (session == null || IsAsApplied);
            _session = session;
            if (session == null || isOurs) return;
            var isKnown = _hasBegun && session.Visualisation.Length == _calibrated.Length;
            _calibrated = session.Visualisation;
            _profile = session.Profile;
            // A shift that was seen with another L_visu says nothing of this one.
            if (_hasBegun && !isKnown) _ms = 0;
            _ms = Allowed(_ms);
            _hasBegun = true;
            Apply();
        }

        bool IsAsApplied => _session.Visualisation.Length == _applied && _session.Profile == (_ms == 0 ? _profile : null);

        void Apply()
        {
            if (_ms != 0) _session.Visualisation = VisualisationLatency.FromMilliseconds(_calibrated.Length.TotalMilliseconds + _ms);
            else if (!IsCalibrated) GoBack();
            _applied = _session.Visualisation.Length;
        }

        bool IsCalibrated => _session.Visualisation.Length == _calibrated.Length && _session.Profile == _profile;

        void GoBack()
        {
            if (_profile != null) _session.Calibrate(_profile);
            else _session.Visualisation = _calibrated;
        }

        double Allowed(double ms)
        {
            if (double.IsNaN(ms)) return 0;
            var kept = Math.Max(-GreatestMs, Math.Min(GreatestMs, ms));
            if (!_hasBegun) return kept;
            var calibrated = _calibrated.Length.TotalMilliseconds;
            return Math.Max(-calibrated, Math.Min(LongestMs - calibrated, kept));
        }
    }
}
