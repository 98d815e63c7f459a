using System;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>Estimates the weights of a joint's mixture from its errors, and selects the weights of the next forecast.</summary>
    /// <remarks>
    /// There are three sets of weights: from all errors except zeros, from the errors at rest, and from the errors in motion. The last two are
    /// regularised towards the first. Two situations use other weights. If the samples at rest are only noise, the position is held. A first move,
    /// which is much faster than the motion of the last few seconds, starts as a line and continues with the prior, because weights from noise or
    /// slow motion do not suit it.
    /// </remarks>
    sealed class WeightSelector
    {
        /// <summary>
        /// Strength of the regularisation (<see cref="MixtureWeights"/>): of the common weights towards the prior, and of the weights at rest or in
        /// motion towards the common weights. With half or twice these values, the errors on recordings change by less than half a percent.
        /// </summary>
        const double Regularisation = 0.2, ClassRegularisation = 0.5;

        /// <summary>
        /// Maximum error that is scored, relative to the RMS error of hold, so that one wrong sample does not outweigh seconds of correct ones: with
        /// a threshold of five, the error on one recording was 6 % larger. Errors that stay larger raise the RMS error within seconds.
        /// </summary>
        const double OutlierThreshold = 8;

        /// <summary>
        /// Minimum evidence (<see cref="MixtureWeights.Evidence"/>) for the detection of outliers, 0.4 s of samples: without it, the
        /// errors are 3 % larger.
        /// </summary>
        const double MinEvidence = 0.02;

        /// <summary>
        /// Time after the start of a first move during which a line predicts it, s. Without the line, the errors of simulated motions are 1.8 %
        /// larger, and those of recordings 0.6 % smaller.
        /// </summary>
        const double StartSeconds = 0.08;

        readonly MixedForecasters _forecasters;
        readonly bool _limitsErrors, _separatesRest, _usesFirstMoves;
        readonly MixtureWeights _overall, _moving, _resting;
        readonly double[] _line, _hold;
        bool _mustSolve;

        public WeightSelector(MixedForecasters forecasters, PredictionParts parts)
        {
            _forecasters = forecasters;
            _limitsErrors = (parts & PredictionParts.OutlierThreshold) != 0;
            _separatesRest = (parts & PredictionParts.RestWeights) != 0;
            _usesFirstMoves = (parts & PredictionParts.FirstMoves) != 0;
            (_line, _hold) = (new double[forecasters.Count], new double[forecasters.Count]);
            _hold[MixedForecasters.Hold] = _line[MixedForecasters.Line] = 1;
            _overall = new MixtureWeights(Regularisation, forecasters.Prior);
            _moving = new MixtureWeights(ClassRegularisation, forecasters.Prior);
            _resting = new MixtureWeights(ClassRegularisation, forecasters.Prior);
            Reset();
        }

        /// <summary>The weights of the next forecast, one per forecaster.</summary>
        public double[] Values { get; private set; }

        /// <summary>Maximum error that is scored, in the samples' unit; infinite until there is enough evidence.</summary>
        public double Threshold => _limitsErrors && _overall.Evidence >= MinEvidence
            ? OutlierThreshold * Math.Sqrt(_overall.MeanSquare(MixedForecasters.Hold)) : double.PositiveInfinity;

        /// <summary>Adds the errors of all forecasters for one sample.</summary>
        /// <param name="errors">Limited by <see cref="Threshold"/>, one per forecaster.</param>
        /// <param name="wasAtRest">Whether the joint was at rest when the forecasts were made.</param>
        /// <param name="forgettingFactor">Forgetting factor of one sample, 0 to 1.</param>
        public void Learn(double[] errors, bool wasAtRest, double forgettingFactor)
        {
            // A solve takes only a few steps, so at rest the common weights are solved again, even if they learn nothing.
            _mustSolve = wasAtRest;
            if (wasAtRest && _separatesRest) _resting.Learn(errors, forgettingFactor);
            // Errors of zero, at rest without noise, show no difference between the forecasters.
            if (Array.TrueForAll(errors, error => error == 0)) return;
            _mustSolve = true;
            _overall.Learn(errors, forgettingFactor);
            if (!wasAtRest && _separatesRest) _moving.Learn(errors, forgettingFactor);
        }

        /// <summary>Solves for the weights of the next forecast.</summary>
        /// <param name="forgettingFactor">Forgetting factor of one sample, 0 to 1.</param>
        public void Solve(MotionState motion, double forgettingFactor)
        {
            var (prior, gain) = (_forecasters.PriorFor(motion.Samples[0]), 1 - forgettingFactor);
            if (_mustSolve) _overall.Solve(prior, gain);
            _mustSolve = false;
            if (motion.Rest.IsOnlyNoise) Values = _hold;
            else if (_usesFirstMoves && IsFirstMove(motion)) Values = IsStart(motion) ? _line : prior;
            else if (!_separatesRest) Values = _overall.Values;
            else
            {
                var weights = motion.Rest.IsAtRest ? _resting : _moving;
                weights.Solve(_overall.Values, gain);
                Values = weights.Values;
            }
        }

        public void Reset()
        {
            _mustSolve = false;
            _overall.Reset(_forecasters.Prior);
            _moving.Reset(_forecasters.Prior);
            _resting.Reset(_forecasters.Prior);
            Values = _forecasters.Prior;
        }

        bool IsFirstMove(MotionState motion)
        {
            var displacement = motion.Speed * motion.Horizon;
            return displacement * displacement > Mixer.FirstMoveRatio * _overall.MeanSquare(MixedForecasters.Hold);
        }

        // At least the first interval of a move counts as its start. The margins of 1 % and 0.1 ms allow for an interval above the mean.
        static bool IsStart(MotionState motion) =>
            motion.Samples.NewestTime - motion.Start < Math.Max(StartSeconds, 1.01 * motion.MeanInterval) + 1e-4;
    }
}
