using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>A Gaussian process whose variance is scaled by its own past errors.</summary>
    /// <remarks>
    /// The kernel determines how the standard deviation grows with the horizon, but not its scale, because the motion of a robot is not stationary.
    /// A scale from the quadratic form of the newest samples would underestimate the errors of fast moves by a third, and would grow only after the
    /// error. Therefore each new sample is compared with the forecast made one horizon before it. The scale is the mean of the squared errors,
    /// each divided by the variance of the unscaled process at that horizon. prediction-reference.md lists the fraction of errors within the
    /// deviation.
    /// </remarks>
    sealed class CalibratedProcess : Forecaster
    {
        /// <summary>
        /// Time constant of the mean of the squared errors, in s. Between 1 s and 10 s, the fractions of errors within the deviations change by at
        /// most 3 %.
        /// </summary>
        const double ErrorTimeConstant = 3;

        readonly GaussianProcess _process = new GaussianProcess();
        readonly LinearForecaster _mean;
        int _errors;
        double _variance;

        public CalibratedProcess() => _mean = new LinearForecaster(_process);

        public override int Samples => _process.Samples;

        public override int MaxSamples => int.MaxValue;

        public override bool Solve(MotionState motion)
        {
            if (motion.IsNewest) Learn(motion);
            return _mean.Solve(motion);
        }

        public override double At(double ahead, int component) => _mean.At(ahead, component);

        /// <returns>NaN before the first comparison of a forecast with a sample.</returns>
        public override double DeviationAt(double ahead) =>
            _errors == 0 ? double.NaN : Math.Sqrt(_variance * _process.VarianceAt(ahead));

        public override void Reset()
        {
            _errors = 0;
            _variance = 0;
        }

        // Solves again from the samples that were the newest one horizon ago, so past forecasts need not be stored.
        void Learn(MotionState motion)
        {
            var age = AgeAtHorizon(motion);
            if (age == 0 || !_mean.Solve(motion, Samples, age)) return;
            var (ahead, squares) = (-motion.Times[age], 0.0);
            for (var c = 0; c < motion.Components; c++)
            {
                var error = -motion.Displacements[age * motion.Components + c] - _mean.At(ahead, c);
                squares += error * error;
            }
            var square = squares / (motion.Components * _process.VarianceAt(ahead));
            if (!double.IsFinite(square)) return;
            // The first errors are averaged without weights.
            var gain = Math.Max(1 - Math.Exp(-motion.Timing.Interval / ErrorTimeConstant), 1.0 / ++_errors);
            _variance += gain * (square - _variance);
        }

        // Returns the age of the sample that is nearest to one horizon before the newest sample; 0 if too few samples precede it.
        int AgeAtHorizon(MotionState motion)
        {
            double Distance(int age) => Math.Abs(motion.Times[age] + motion.Timing.Horizon);
            var oldest = motion.Count - Samples;
            if (oldest < 1) return 0;
            var best = 1;
            while (best < oldest && Distance(best + 1) < Distance(best)) best++;
            return best;
        }
    }
}
