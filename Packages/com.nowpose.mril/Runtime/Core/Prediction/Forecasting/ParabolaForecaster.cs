using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>
    /// Forecasts with a parabola that is constant after its vertex. The velocity and acceleration in the newest sample, or the newest three samples,
    /// determine the parabola.
    /// </summary>
    sealed class ParabolaForecaster : Forecaster
    {
        double _speed;
        double _bend;
        double _stop;

        public override int Samples => 3;

        public override bool Solve(MotionState motion)
        {
            if (motion.ConnectedSamples < Samples) return false;
            if (!double.IsNaN(motion.Samples[0].Velocity)) TakeReported(motion);
            else TakeThree(motion);
            _stop = _speed * _bend < 0 ? -_speed / (2 * _bend) : double.PositiveInfinity;
            return true;
        }

        public override double At(double ahead)
        {
            var x = Math.Min(ahead, _stop);
            return x * (_speed + _bend * x);
        }

        public override void Fill(double[] table, int start, int points)
        {
            var (speed, bend, stop) = (_speed, _bend, _stop);
            var ahead = 0.0;
            for (var i = start; i < start + points; i++, ahead += ForecastTable.Step)
            {
                var x = ahead > stop ? stop : ahead;
                table[i] = x * (speed + bend * x);
            }
        }

        // Uses the Taylor series. If only the velocity is reported, the previous sample determines the second derivative.
        void TakeReported(MotionState motion)
        {
            ref readonly var newest = ref motion.Samples[0];
            _speed = newest.Velocity;
            _bend = double.IsNaN(newest.Acceleration) ? (newest.Velocity - motion.Speed) / motion.Interval : newest.Acceleration / 2;
        }

        void TakeThree(MotionState motion)
        {
            var samples = motion.Samples;
            var h1 = samples[1].Time - samples[0].Time;
            var h2 = samples[2].Time - samples[0].Time;
            var s1 = (samples[1].Position - samples[0].Position) / h1;
            var s2 = (samples[2].Position - samples[0].Position) / h2;
            _bend = (s1 - s2) / (h1 - h2);
            _speed = s1 - _bend * h1;
            // The vertex is before the newest sample, so the forecast is constant.
            if (_speed * (samples[0].Position - samples[1].Position) <= 0) _speed = _bend = 0;
        }
    }
}
