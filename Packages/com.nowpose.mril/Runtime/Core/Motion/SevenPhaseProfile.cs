using System;
using Nowpose.Messages;

namespace Nowpose.Motion
{
    /// <summary>
    /// The time-optimal move from rest to rest under limits on velocity, acceleration and jerk, the set-point of
    /// Schnierle &amp; Röck 2022, Fig. 12: seven phases of constant jerk, fewer when the stroke is short.
    /// </summary>
    /// <remarks>
    /// The unit of length is arbitrary (mm, m, rad) but must be the same for distance and limits. Times are in seconds from the start of the
    /// move. The position is 0 before the start, and the distance after <see cref="Duration"/>. <c>default</c> is a move of zero
    /// distance and duration. Immutable and thread-safe.
    /// </remarks>
    readonly struct SevenPhaseProfile
    {
        readonly double _distance;
        readonly double _jerk;
        readonly double _jerkTime;
        readonly double _rampTime;
        readonly double _peakVelocity;

        /// <param name="distance">Signed stroke; 0 gives a move of zero duration.</param>
        /// <param name="maxVelocity">Maximum velocity in units of length per second, positive.</param>
        /// <param name="maxAcceleration">Maximum acceleration in units of length per second squared, positive.</param>
        /// <param name="maxJerk">Maximum jerk in units of length per second cubed, positive.</param>
        /// <exception cref="ArgumentOutOfRangeException">A limit is not positive, or a value is not finite.</exception>
        public SevenPhaseProfile(double distance, double maxVelocity, double maxAcceleration, double maxJerk)
        {
            if (double.IsNaN(distance) || double.IsInfinity(distance))
                throw new ArgumentOutOfRangeException(nameof(distance), distance, SettingMessages.NotFinite);
            RequirePositive(maxVelocity, nameof(maxVelocity));
            RequirePositive(maxAcceleration, nameof(maxAcceleration));
            RequirePositive(maxJerk, nameof(maxJerk));

            _distance = distance;
            _jerk = _jerkTime = _rampTime = Duration = 0;
            var stroke = Math.Abs(distance);
            _peakVelocity = Math.Min(maxVelocity, VelocityOfStroke(stroke, maxAcceleration, maxJerk));
            if (_peakVelocity == 0) return;

            // A ramp reaches the maximum acceleration only if it gains more than a²/j of velocity.
            var reachesAcceleration = _peakVelocity * maxJerk >= maxAcceleration * maxAcceleration;
            _jerkTime = reachesAcceleration ? maxAcceleration / maxJerk : Math.Sqrt(_peakVelocity / maxJerk);
            _jerk = maxJerk;
            _rampTime = _peakVelocity / (maxJerk * _jerkTime) + _jerkTime;
            Duration = _rampTime + Math.Max(_rampTime, stroke / _peakVelocity);
        }

        /// <summary>Duration of the move, in s.</summary>
        public double Duration { get; }

        /// <summary>Returns the distance covered since the start, signed.</summary>
        public double PositionAt(double t)
        {
            var half = Duration / 2;
            if (!(t > 0)) return 0;
            if (t >= Duration) return _distance;
            var stroke = Math.Abs(_distance);
            return Math.Sign(_distance) * (t <= half ? Covered(t) : stroke - Covered(Duration - t));
        }

        /// <summary>Returns the signed velocity in units of length per second.</summary>
        public double VelocityAt(double t)
        {
            if (!(t > 0) || t >= Duration) return 0;
            return Math.Sign(_distance) * Speed(Math.Min(t, Duration - t));
        }

        /// <summary>Returns the signed acceleration in units of length per second squared; continuous, and 0 outside the move.</summary>
        public double AccelerationAt(double t)
        {
            if (!(t > 0) || t >= Duration) return 0;
            return t <= Duration / 2
                ? Math.Sign(_distance) * RampAcceleration(t)
                : -Math.Sign(_distance) * RampAcceleration(Duration - t);
        }

        /// <summary>Returns the peak velocity at which acceleration and deceleration alone cover the stroke.</summary>
        static double VelocityOfStroke(double stroke, double acceleration, double jerk)
        {
            // Without a phase of constant acceleration: stroke = 2 v sqrt(v/j). Computes roots first, so that a tiny stroke does not underflow.
            var root = Math.Cbrt(stroke);
            var withoutPlateau = root * root * Math.Cbrt(jerk / 4);
            if (withoutPlateau * jerk <= acceleration * acceleration) return withoutPlateau;
            // With a phase of constant acceleration: stroke = v²/a + v a/j, solved in a form that avoids cancellation.
            var jerkTime = acceleration / jerk;
            return 2 * stroke / (jerkTime + Math.Sqrt(jerkTime * jerkTime + 4 * stroke / acceleration));
        }

        // The second half of the move mirrors the first half, so only the first half is computed.
        double Covered(double t)
        {
            if (t >= _rampTime) return _peakVelocity * (t - _rampTime / 2);
            if (t <= _jerkTime) return _jerk * t * t * t / 6;
            var left = _rampTime - t;
            if (left <= _jerkTime) return _peakVelocity * (t - _rampTime / 2) + _jerk * left * left * left / 6;
            var constant = t - _jerkTime;
            return _jerk * _jerkTime * (_jerkTime * _jerkTime / 6 + constant * (_jerkTime + constant) / 2);
        }

        double Speed(double t)
        {
            if (t >= _rampTime) return _peakVelocity;
            if (t <= _jerkTime) return _jerk * t * t / 2;
            var left = _rampTime - t;
            if (left <= _jerkTime) return _peakVelocity - _jerk * left * left / 2;
            return _jerk * _jerkTime * (t - _jerkTime / 2);
        }

        double RampAcceleration(double t)
        {
            if (t >= _rampTime) return 0;
            return _jerk * Math.Min(_jerkTime, Math.Min(t, _rampTime - t));
        }

        static void RequirePositive(double value, string name)
        {
            if (!(value > 0) || double.IsInfinity(value))
                throw new ArgumentOutOfRangeException(name, value, SettingMessages.NotPositive);
        }
    }
}
