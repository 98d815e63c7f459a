using System;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>
    /// Forecasts a joint by the Taylor series of the velocity and acceleration that the control system reports, and by another forecaster while nothing is
    /// reported. The series is constant after its vertex, because drives stop far more often than they reverse.
    /// </summary>
    sealed class ReportedForecaster : Forecaster
    {
        readonly Forecaster _otherwise;
        // Reported velocity, half of the acceleration, and the time of the vertex, in s after the newest sample.
        double _velocity, _halfAcceleration, _stop;
        bool _isReported;

        public ReportedForecaster(Forecaster otherwise) => _otherwise = otherwise;

        public override int UsedSamples => _otherwise.UsedSamples;

        // The velocity and the acceleration are known from the newest sample alone, for example directly after a stop.
        public override int SamplesInMixture(MotionState motion) =>
            IsReported(motion) && !double.IsNaN(motion.ReportedAcceleration) ? 1 : base.SamplesInMixture(motion);

        public override bool Solve(MotionState motion)
        {
            _isReported = IsReported(motion);
            if (!_isReported) return _otherwise.Solve(motion);
            _velocity = motion.ReportedVelocity;
            // Without an acceleration, the mean speed in the last interval determines the second derivative.
            _halfAcceleration = double.IsNaN(motion.ReportedAcceleration)
                ? (_velocity - motion.Velocity[0]) / motion.Interval : motion.ReportedAcceleration / 2;
            _stop = _velocity * _halfAcceleration < 0 ? -_velocity / (2 * _halfAcceleration) : double.PositiveInfinity;
            return true;
        }

        public override double At(double ahead, int component)
        {
            if (!_isReported) return _otherwise.At(ahead, component);
            var x = Math.Min(ahead, _stop);
            return x * (_velocity + _halfAcceleration * x);
        }

        static bool IsReported(MotionState motion) => !double.IsNaN(motion.ReportedVelocity);

        public override void Fill(double[] table, int start, int points, int components)
        {
            if (_isReported) base.Fill(table, start, points, components);
            else _otherwise.Fill(table, start, points, components);
        }
    }
}
