using System;
using Nowpose.Prediction.State;

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

        /// <summary>
        /// Time constant with which the distance of the mean from the newest sample decays, in s: short compared with any latency that is worth
        /// compensating. The mean does not pass through noisy samples, and the displayed position must not jump there.
        /// </summary>
        const double OffsetTimeConstant = 0.005;

        readonly GaussianProcess _process = new GaussianProcess();
        readonly double[] _offsets;
        int _errors;
        double _variance;

        public CalibratedProcess(int components) => _offsets = new double[components];

        public override int UsedSamples => _process.UsedSamples;

        public override bool Solve(MotionState motion)
        {
            if (motion.IsNewest) Learn(motion);
            if (!_process.Solve(motion)) return false;
            for (var c = 0; c < _offsets.Length; c++) _offsets[c] = _process.At(0, c);
            return true;
        }

        public override double At(double ahead, int component) =>
            _process.At(ahead, component) - _offsets[component] * Math.Exp(-ahead / OffsetTimeConstant);

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
            if (age == 0 || !_process.Solve(motion, age)) return;
            var (ahead, squares) = (-motion.Times[age], 0.0);
            for (var c = 0; c < motion.Components; c++)
            {
                var error = -motion.Displacements[age * motion.Components + c] - _process.At(ahead, c);
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
            var oldest = motion.Count - UsedSamples;
            if (oldest < 1) return 0;
            var best = 1;
            while (best < oldest && Distance(best + 1) < Distance(best)) best++;
            return best;
        }
    }
}
