using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>
    /// A parabola, constant after its vertex: from the velocity and acceleration in the newest sample, or through the newest three
    /// samples.
    /// </summary>
    sealed class ParabolaForecaster : Forecaster
    {
        const double MaxMagnitude = 1e50;

        readonly bool _usesReported;
        double _speed;
        double _bend;
        double _stop;

        /// <param name="usesReported">
        /// Whether to use velocity and acceleration of the newest sample; if they are not reported, three samples are used.
        /// </param>
        public ParabolaForecaster(bool usesReported) => _usesReported = usesReported;

        public override int Samples => 3;

        public override bool Solve(MotionState motion)
        {
            if (motion.Connected < Samples) return false;
            // False for NaN (not reported), and for absurd values, which overflow.
            if (_usesReported && Math.Abs(motion.Samples[0].Velocity) < MaxMagnitude) TakeReported(motion);
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

        // Taylor series; if only the velocity is reported, the previous sample determines the second derivative.
        void TakeReported(MotionState motion)
        {
            ref readonly var newest = ref motion.Samples[0];
            _speed = newest.Velocity;
            _bend = Math.Abs(newest.Acceleration) < MaxMagnitude ? newest.Acceleration / 2 : (newest.Velocity - motion.Speed) / motion.Interval;
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
            // The vertex is in the past.
            if (_speed * (samples[0].Position - samples[1].Position) <= 0) _speed = _bend = 0;
        }
    }
}
