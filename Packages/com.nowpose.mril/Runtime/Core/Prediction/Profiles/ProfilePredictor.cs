using System;
using Nowpose.Motion;

namespace Nowpose.Prediction.Profiles
{
    /// <summary>For axes whose drive limits are known: the newest move is the 7-phase move from rest to rest that its samples lie on.</summary>
    /// <remarks>
    /// The first samples of a move tell when it began, for until it brakes every move under the same limits is the same
    /// (Schnierle &amp; Röck 2022, Fig. 12). A sample that lags behind that tells the stroke, and so the rest of the move.
    /// Moves that are not from rest to rest are predicted wrongly: whether to trust it is for a gate to say.
    /// </remarks>
    public sealed class ProfilePredictor : IJointPredictor
    {
        /// <summary>A move counts as braking when it lags by so much, s: what rounding of stamps cannot explain.</summary>
        const double LeastLag = 0.6e-3;

        /// <summary>Ways below this share of the longest are rest.</summary>
        const double RestShare = 1e-4;

        /// <summary>A sample lies on a move when it is off by less than this share of the longest way between two.</summary>
        const double ToleranceShare = 0.02;

        const int Bisections = 50;

        readonly PredictionLimits _limits;
        readonly SampleHistory _history = new SampleHistory(3);
        readonly double _longestStroke;
        readonly SevenPhaseProfile _endless;
        SevenPhaseProfile _move;
        double _longestWay;
        double _restPosition;
        double _start;
        double _direction;
        bool _isKnown;

        /// <param name="limits">Velocity, acceleration and jerk must be finite.</param>
        /// <exception cref="ArgumentException">A limit of the drive is not known.</exception>
        public ProfilePredictor(PredictionLimits limits)
        {
            _limits = limits ?? throw new ArgumentNullException(nameof(limits));
            if (!HasLimits(limits)) throw new ArgumentException("velocity, acceleration and jerk must be known", nameof(limits));
            // A stroke long enough that none is braked for within a minute.
            _longestStroke = limits.Velocity * 60;
            _endless = Profile(_longestStroke);
            Reset();
        }

        /// <inheritdoc/>
        public double Hold => _history.NewestPosition;

        /// <inheritdoc/>
        public double NewestTime => _history.NewestTime;

        /// <summary>Whether limits are enough for this predictor.</summary>
        public static bool HasLimits(PredictionLimits limits) =>
            double.IsFinite(limits.Velocity) && double.IsFinite(limits.Acceleration) && double.IsFinite(limits.Jerk);

        /// <inheritdoc/>
        public SampleOutcome Add(in JointSample sample)
        {
            var outcome = _history.Add(sample);
            if (outcome == SampleOutcome.Accepted) Follow();
            return outcome;
        }

        /// <inheritdoc/>
        /// <returns><see cref="PredictionKind.None"/> where the motion is none of these moves.</returns>
        public JointPrediction At(double time)
        {
            if (_history.Count == 0 || !_isKnown) return new JointPrediction(Hold, PredictionKind.None);
            var ahead = time - NewestTime;
            var kind = ahead <= 0 ? PredictionKind.Interpolated : ahead > _limits.HorizonCap ? PredictionKind.Held : PredictionKind.Predicted;
            var position = _direction == 0 ? Hold
                : _restPosition + _direction * _move.PositionAt(NewestTime + Math.Min(ahead, _limits.HorizonCap) - _start);
            return new JointPrediction(_limits.Clamp(position), kind);
        }

        /// <inheritdoc/>
        public void Reset()
        {
            _history.Clear();
            _longestWay = 0;
            Rest(0);
            _isKnown = false;
        }

        void Follow()
        {
            if (_history.CountWithoutGap(_limits.MaximumGap) < 2)
            {
                Rest(Hold);
                return;
            }
            _longestWay = Math.Max(_longestWay, Math.Abs(Hold - _history[1].Position));
            if (IsResting()) Rest(Hold);
            else if (_direction == 0) Begin();
            else if (_isKnown) Continue();
        }

        bool IsResting() => _history.Count == 3 && IsRest(0) && IsRest(1);

        bool IsRest(int age) => Math.Abs(_history[age].Position - _history[age + 1].Position) <= RestShare * _longestWay;

        void Rest(double position)
        {
            _restPosition = position;
            _direction = 0;
            _isKnown = true;
        }

        // Samples so near to rest hardly tell when it ended; they are taken for rest.
        void Begin()
        {
            var way = Hold - _restPosition;
            if (Math.Abs(way) <= RestShare * _longestWay) return;
            _direction = Math.Sign(way);
            _move = _endless;
            _start = NewestTime - TimeTo(Math.Abs(way));
            // It cannot have begun before it was last seen at rest.
            _isKnown = _start > _history[1].Time - LeastLag;
        }

        void Continue()
        {
            var elapsed = NewestTime - _start;
            var way = _direction * (Hold - _restPosition);
            if (HasBraked && elapsed > _move.Duration && Math.Abs(Hold - End) > RestShare * _longestWay)
            {
                // The next move has begun, after a dwell too short to be seen.
                Rest(End);
                Begin();
                return;
            }
            var lag = way > 0 ? elapsed - TimeTo(way) : double.PositiveInfinity;
            if (!HasBraked && Math.Abs(lag) <= LeastLag) _start += lag;
            else _isKnown = lag > 0 && TryFindStroke(way, elapsed) && LiesOnMove(1);
        }

        bool HasBraked => !_move.Equals(_endless);

        double End => _restPosition + _direction * _move.PositionAt(_move.Duration);

        bool LiesOnMove(int age)
        {
            var expected = _restPosition + _direction * _move.PositionAt(_history[age].Time - _start);
            return Math.Abs(_history[age].Position - expected) <= ToleranceShare * _longestWay;
        }

        // The longer the stroke the further the axis has come by now, up to where all strokes are the same.
        bool TryFindStroke(double way, double elapsed)
        {
            double shorter = 0, longer = _longestStroke;
            for (var i = 0; i < Bisections; i++)
            {
                var stroke = (shorter + longer) / 2;
                if (Profile(stroke).PositionAt(elapsed) < way) shorter = stroke;
                else longer = stroke;
            }
            _move = Profile(longer);
            return longer < 0.999 * _longestStroke;
        }

        double TimeTo(double way)
        {
            double earlier = 0, later = _endless.Duration;
            for (var i = 0; i < Bisections; i++)
            {
                var time = (earlier + later) / 2;
                if (_endless.PositionAt(time) < way) earlier = time;
                else later = time;
            }
            return later;
        }

        SevenPhaseProfile Profile(double stroke) => new SevenPhaseProfile(stroke, _limits.Velocity, _limits.Acceleration, _limits.Jerk);
    }
}
