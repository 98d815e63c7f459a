using System;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>Forecasts that a move brakes as it has accelerated, for machines that do both with the same acceleration and jerk.</summary>
    /// <remarks>
    /// While the speed decreases, it finds the time m during the acceleration at which the displacement in the following interval equals the newest one. If
    /// the displacements before t are also those after m, the move ends like the time reversal of its start: x(t + τ) = x(t) + x(m) − x(m − τ). A move that
    /// began at rest ends at rest. After a wrong sample, the rest of the move is not forecast.
    /// </remarks>
    sealed class BrakingForecaster : Forecaster
    {
        /// <summary>
        /// Number of newest displacements that must be those of the acceleration in the opposite order. With 2, the errors on recordings are 0.3 % larger,
        /// and those of simulated motions 0.3 % smaller.
        /// </summary>
        const int Compared = 3;

        /// <summary>
        /// Maximum RMS difference of these displacements, relative to their RMS; also the minimum relative decrease of the speed in an interval. At constant
        /// velocity, the speed changes by less, by noise and rounding.
        /// </summary>
        const double MaxDifferenceRatio = 0.02;

        /// <summary>
        /// Maximum speed at which another acceleration begins a new move, relative to the maximum speed of the move: a smaller change of the speed may be
        /// noise. With 0.8, the errors change by at most 0.1 %.
        /// </summary>
        const double NewMoveRatio = 0.5;

        /// <summary>Number of bisection steps: for an acceleration of 2 s, they find m to 0.5 ms.</summary>
        const int Bisections = 12;

        readonly int _components;
        readonly MotionHistory _history;
        MotionState _motion;
        int _starts;
        double _start, _maxSpeed, _maxSpeedAt;
        bool _beganAtRest;

        // Index of the time m in the history.
        double _match;

        /// <param name="history">The past of this motion, which candidates share.</param>
        public BrakingForecaster(MotionHistory history) => (_components, _history) = (history.Components, history);

        /// <returns>False if the motion does not brake as it has accelerated.</returns>
        public override bool Solve(MotionState motion)
        {
            _motion = motion;
            _history.Take(motion);
            if (!_history.HasStarted) return false;
            if (_starts != _history.Starts) Start();
            double speed = motion.Speed, before = Vectors.Length(motion.VelocityBefore);
            FollowMove(speed, before);
            return !motion.IsStill && speed < (1 - MaxDifferenceRatio) * before && TryFind();
        }

        public override double At(double ahead, int component)
        {
            var mirrored = _match - ahead / _history.Step;
            // Before the start at rest, the history contains the end of another move.
            if (_beganAtRest) mirrored = Math.Max(mirrored, _history.IndexOf(_start));
            return _history.At(_match, component) - _history.At(mirrored, component);
        }

        public override void Reset() => _history.Reset();

        // The times of an earlier history are not in this one.
        void Start() => (_starts, _start, _maxSpeed, _beganAtRest) = (_history.Starts, _motion.TimeAt(_motion.Count - 1), 0, false);

        void FollowMove(double speed, double before)
        {
            var (isStill, acceleratesAgain) = (_motion.IsStill, speed > before && before < NewMoveRatio * _maxSpeed);
            var reverses = Vectors.Dot(_motion.Velocity, _motion.VelocityBefore) < 0;
            if (isStill || reverses || acceleratesAgain) (_start, _maxSpeed, _beganAtRest) = (_motion.TimeAt(1), 0, isStill);
            if (speed > _maxSpeed) (_maxSpeed, _maxSpeedAt) = (speed, _motion.NewestTime);
        }

        bool TryFind()
        {
            var (interval, newest) = (-_motion.Times[1] / _history.Step, _motion.DistanceFromPrevious(0));
            double slower = _history.IndexOf(_start) - interval, faster = _history.IndexOf(_maxSpeedAt) - interval;
            for (var i = 0; i < Bisections; i++)
            {
                _match = (slower + faster) / 2;
                if (DisplacementAfter(_match, interval) < newest) slower = _match;
                else faster = _match;
            }
            return _history.Covers(_match - ForecastTable.Span / _history.Step) && _history.Covers(IndexAfter(_match, Compared)) && IsMirrored();
        }

        bool IsMirrored()
        {
            double differences = 0, squares = 0;
            for (var age = 0; age < Compared; age++)
            {
                double from = IndexAfter(_match, age), to = IndexAfter(_match, age + 1);
                for (var c = 0; c < _components; c++)
                {
                    var displacement = Displacement(age, c);
                    var difference = displacement - (_history.At(to, c) - _history.At(from, c));
                    differences += difference * difference;
                    squares += displacement * displacement;
                }
            }
            return differences < MaxDifferenceRatio * MaxDifferenceRatio * squares;
        }

        double DisplacementAfter(double index, double interval)
        {
            var square = 0.0;
            for (var c = 0; c < _components; c++)
            {
                var displacement = _history.At(index + interval, c) - _history.At(index, c);
                square += displacement * displacement;
            }
            return Math.Sqrt(square);
        }

        // The index that is as far after an index as the newest sample is after the sample with this age.
        double IndexAfter(double index, int age) => index - _motion.Times[age] / _history.Step;

        double Displacement(int age, int component) =>
            _motion.Displacements[age * _components + component] - _motion.Displacements[(age + 1) * _components + component];
    }
}
