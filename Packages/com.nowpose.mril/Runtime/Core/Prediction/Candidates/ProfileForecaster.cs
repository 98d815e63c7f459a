using System;
using Nowpose.Motion;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>
    /// Forecasts by an S-curve profile (7 phases, from rest to rest) that is fitted to the samples of the newest move. For axes whose drive limits
    /// are known.
    /// </summary>
    /// <remarks>
    /// The first samples of a move determine its start, because all moves under the same limits are equal until they brake
    /// (Schnierle &amp; Röck 2022, Fig. 12). A sample that lags behind that curve determines the stroke, and therefore the remainder of the move.
    /// Other moves are predicted wrongly, so a <see cref="CandidateGate"/> decides whether the forecast is used.
    /// </remarks>
    sealed class ProfileForecaster : Forecaster
    {
        /// <summary>Minimum lag of a move that brakes, in s: larger than the rounding of stamps, which is 0.5 ms for whole milliseconds.</summary>
        const double MinLag = 0.6e-3;

        /// <summary>
        /// Maximum distance of a sample from its move, relative to the displacement in an interval at the maximum speed. It allows for noise and for
        /// the drive's following error; the gate rejects a profile that fits although it is wrong.
        /// </summary>
        const double ToleranceRatio = 0.02;

        /// <summary>
        /// Number of bisection steps. They determine the start of a move to 0.2 µs, and its stroke to 0.2 µm at a limit of 1 m/s. With 50, the 99th
        /// percentile of a sample of seven joints is 12 to 23 % higher.
        /// </summary>
        const int Bisections = 28;

        /// <summary>Duration of the longest move at the maximum speed, in s. A longer move is predicted like this one until it brakes.</summary>
        const double MaxDuration = 60;

        readonly PredictionLimits _limits;
        readonly double _maxStroke;
        readonly SevenPhaseProfile _unbraked;
        SevenPhaseProfile _move;
        MotionState _motion;
        double _restPosition;
        double _start;
        double _direction;
        bool _isKnown;
        bool _hasBraked;

        /// <param name="limits">Limits that are sufficient, see <see cref="HasLimits"/>.</param>
        public ProfileForecaster(PredictionLimits limits)
        {
            _limits = limits;
            _maxStroke = limits.Velocity * MaxDuration;
            _unbraked = Profile(_maxStroke);
            Reset();
        }

        /// <summary>Returns whether the limits are sufficient for this forecaster.</summary>
        public static bool HasLimits(PredictionLimits limits) =>
            double.IsFinite(limits.Velocity) && double.IsFinite(limits.Acceleration) && double.IsFinite(limits.Jerk);

        /// <returns>False if the motion does not match a profile.</returns>
        public override bool Solve(MotionState motion)
        {
            _motion = motion;
            if (motion.Count < 2 || motion.StillSamples > 1) Rest(motion.Newest[0]);
            else if (_direction == 0) StartMove();
            else if (_isKnown) ContinueMove();
            return _isKnown;
        }

        public override double At(double ahead, int component) =>
            _direction == 0 ? 0 : PositionAt(_motion.NewestTime + ahead) - _motion.Newest[0];

        public override void Reset()
        {
            Rest(0);
            _isKnown = false;
        }

        void Rest(double position)
        {
            _restPosition = position;
            _direction = 0;
            _isKnown = true;
        }

        // Samples close to rest do not determine the start accurately, so they count as rest.
        void StartMove()
        {
            var displacement = _motion.Newest[0] - _restPosition;
            if (Math.Abs(displacement) <= _motion.StillDistance) return;
            _direction = Math.Sign(displacement);
            _move = _unbraked;
            _hasBraked = false;
            _start = _motion.NewestTime - TimeTo(Math.Abs(displacement));
            // The move cannot have begun before the last sample at rest.
            _isKnown = _start > _motion.PreviousTime - MinLag;
        }

        void ContinueMove()
        {
            var (newest, elapsed, end) = (_motion.Newest[0], _motion.NewestTime - _start, PositionAt(double.PositiveInfinity));
            var displacement = _direction * (newest - _restPosition);
            if (_hasBraked && elapsed > _move.Duration && Math.Abs(newest - end) > _motion.StillDistance)
            {
                // The next move has begun after a dwell too short to be detected.
                Rest(end);
                StartMove();
                return;
            }
            var lag = displacement > 0 ? elapsed - TimeTo(displacement) : double.PositiveInfinity;
            if (!_hasBraked && Math.Abs(lag) <= MinLag) _start += lag;
            else _isKnown = lag > 0 && TryFindStroke(displacement, elapsed) && IsPreviousOnMove;
        }

        bool IsPreviousOnMove => Math.Abs(_motion.PositionAt(1, 0) - PositionAt(_motion.PreviousTime)) <= ToleranceRatio * _motion.MaxDisplacement;

        double PositionAt(double time) => _restPosition + _direction * _move.PositionAt(time - _start);

        // A longer stroke means a larger displacement at this time, until all strokes are equal.
        bool TryFindStroke(double displacement, double elapsed)
        {
            double shorter = 0, longer = _maxStroke;
            for (var i = 0; i < Bisections; i++)
            {
                var stroke = (shorter + longer) / 2;
                if (Profile(stroke).PositionAt(elapsed) < displacement) shorter = stroke;
                else longer = stroke;
            }
            _move = Profile(longer);
            _hasBraked = true;
            return longer < _maxStroke;
        }

        double TimeTo(double displacement)
        {
            double earlier = 0, later = _unbraked.Duration;
            for (var i = 0; i < Bisections; i++)
            {
                var time = (earlier + later) / 2;
                if (_unbraked.PositionAt(time) < displacement) earlier = time;
                else later = time;
            }
            return later;
        }

        SevenPhaseProfile Profile(double stroke) => new SevenPhaseProfile(stroke, _limits.Velocity, _limits.Acceleration, _limits.Jerk);
    }
}
