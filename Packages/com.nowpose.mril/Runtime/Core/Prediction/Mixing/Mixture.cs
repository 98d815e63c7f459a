using System;
using Nowpose.Prediction.Candidates;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>
    /// Forecasts by a mixture: the weighted sum of forecasts whose weights minimise its recent error. A candidate replaces the mixture while
    /// its error is clearly smaller.
    /// </summary>
    /// <remarks>
    /// No single forecaster is best for every motion: the paper's quadratic is better on clean swings, a straight line on many real machines.
    /// Each new sample shows the errors of the forecasts that were made one horizon before it, the weights are solved from these errors
    /// (<see cref="MixtureWeights"/>), and the tables of the forecasters and the displayed one are filled. Each component of an object has its own
    /// weights, which also learn from the other components, because the components have the same kind of motion.
    /// Directly after a jump, the displayed table holds the position. Otherwise, it is that of the best candidate whose gate is open, or else the line at
    /// constant velocity, or else the weighted sum within <see cref="DistanceLimit"/>. The limits of the drive bound the last two. The gates compare with
    /// the weighted sum alone, without the line and without limits.
    /// </remarks>
    sealed class Mixture : Forecaster
    {
        /// <summary>
        /// Time constant of the forgetting factor of the weights, in s. With 10 or 40 s, the mean errors change by at most 0.5 %.
        /// </summary>
        const double TimeConstant = 20;

        /// <summary>
        /// Number of errors, one per component and sample, whose evidence has the same weight as the prior. It is larger than for independent errors, because
        /// successive errors of a component are similar. With 15, the errors of simulated trackers at rest are 0.8 % larger.
        /// </summary>
        const double PriorErrors = 25;

        /// <summary>
        /// Factor by which the line multiplies the speed directly after a change point that did not increase it. Without the factor, the errors on
        /// recordings are 0.4 % larger.
        /// </summary>
        const double SpeedRatioAfterStop = 0.5;

        readonly int _components, _points;
        readonly PredictionLimits _limits;
        readonly ForecasterSet _forecasters;
        readonly Candidate[] _candidates;
        readonly MixtureWeights[] _weights;
        readonly PendingForecasts _pending;

        // Null if this part is not used.
        readonly ChangePointDetector _changePoints;
        readonly DistanceLimit _distance;
        readonly bool _measuresPersistence;

        // The table of the displayed forecast.
        readonly double[] _table;

        double _forgettingFactor;

        /// <param name="limits">Horizon cap, and for a joint the limits of its drive.</param>
        /// <param name="forecasters">Forecasters of the mixture, which other motions may use in turn.</param>
        /// <param name="candidates">Forecasters that may replace the mixture.</param>
        /// <param name="changePoints">Detector for this motion; null to use all samples after change points too.</param>
        /// <param name="distance">Limit for this motion; null for no limit.</param>
        /// <param name="measuresPersistence">Whether the prior is multiplied by the persistence of the motion.</param>
        public Mixture(int components, PredictionLimits limits, ForecasterSet forecasters, Candidate[] candidates,
            ChangePointDetector changePoints, DistanceLimit distance, bool measuresPersistence)
        {
            (_components, _limits, _forecasters, _candidates) = (components, limits, forecasters, candidates);
            (_changePoints, _distance, _measuresPersistence) = (changePoints, distance, measuresPersistence);
            _points = ForecastTable.PointsUpTo(limits.HorizonCap);
            _weights = new MixtureWeights[components];
            for (var c = 0; c < components; c++) _weights[c] = new MixtureWeights(forecasters.Count);
            _pending = new PendingForecasts(components, forecasters, candidates, _weights);
            _table = new double[ForecastTable.Points * components];
            Reset();
        }

        public override double Span => ForecastTable.Span;

        public override bool Solve(MotionState motion)
        {
            if (motion.IsNewest)
            {
                _forgettingFactor = Math.Exp(-motion.Timing.Interval / TimeConstant);
                _changePoints?.Add(motion, _forgettingFactor);
                Learn(motion);
                foreach (var candidate in _candidates) candidate.Add(motion);
            }
            Forecast(motion);
            return motion.Count >= 2;
        }

        public override double At(double ahead, int component) => new TableTime(ahead).Read(_table, 0, component, _components);

        public override void Reset()
        {
            foreach (var candidate in _candidates) candidate.Reset();
            _changePoints?.Reset();
            foreach (var weights in _weights) weights.Reset();
            _pending.Clear();
            _distance?.Clear();
            Array.Clear(_table, 0, _table.Length);
        }

        void Learn(MotionState motion)
        {
            // After a gap or a jump, earlier forecasts are wrong for a reason that no forecaster can know.
            if (motion.Count == 1 || motion.HasJumped) _pending.Clear();
            if (motion.IsPreviousWrong) _pending.DropNewest();
            // One error per component and sample, all of which the weights forget with the same time constant.
            var factorPerError = Math.Exp(-motion.Timing.Interval / (_components * TimeConstant));
            // An error that a wrong sample shows would remain in all means for seconds. The next sample drops its forecasts.
            if (!motion.IsUnconfirmed) _pending.Score(motion, factorPerError);
            var (prior, square) = (Prior(motion), SquareWithinHorizon(motion));
            foreach (var weights in _weights) weights.Solve(prior, PriorErrors * (1 - factorPerError), square);
        }

        // Extrapolation would multiply the noise of a tracker.
        double[] Prior(MotionState motion)
        {
            var share = _measuresPersistence ? Math.Min(Math.Max(motion.MeasurePersistence(), 0), 1) : 1;
            return _forecasters.Prior(!double.IsNaN(motion.ReportedVelocity + motion.ReportedAcceleration), share);
        }

        // The mean square of the components of the displacement within one horizon, at the present speed.
        double SquareWithinHorizon(MotionState motion)
        {
            var displacement = motion.KnownSpeed * motion.Timing.Horizon;
            return displacement * displacement / _components;
        }

        void Forecast(MotionState motion)
        {
            var samples = Math.Min(motion.Connected, _changePoints?.SamplesSince ?? int.MaxValue);
            var isAfterStop = _changePoints != null && samples == 1 && !_changePoints.SpeedIncreased;
            var speedFactor = motion.Connected < 2 ? 0 : isAfterStop ? SpeedRatioAfterStop : 1;
            _forecasters.Fill(motion, samples, speedFactor, _points);
            if (motion.IsNewest)
            {
                _pending.Add(motion);
                _distance?.Add(_pending.DistanceFromLine, _forgettingFactor, motion.IsUnconfirmed);
            }
            FillTable(motion, speedFactor);
        }

        void FillTable(MotionState motion, double speedFactor)
        {
            Array.Clear(_table, 0, _table.Length);
            if (motion.HasJumped) return;
            if (BestCandidate() is { } candidate) candidate.Fill(_table, _points, _components);
            else FillMixture(motion, speedFactor);
            // The displayed position is that of the newest sample at its time.
            for (var c = 0; c < _components; c++) _table[c] = 0;
        }

        Candidate BestCandidate()
        {
            Candidate best = null;
            foreach (var candidate in _candidates)
                if (candidate.ErrorRatio < (best?.ErrorRatio ?? double.PositiveInfinity)) best = candidate;
            return best;
        }

        /// <param name="speedFactor">Factor by which the line multiplies the velocity in the last interval.</param>
        void FillMixture(MotionState motion, double speedFactor)
        {
            // The weights of the last seconds would displace a constant velocity if they include hold.
            for (var c = 0; c < _components; c++)
                if (_changePoints?.IsSteady == true) _forecasters.AddTo(_table, c, ForecasterSet.Line, 1, _points);
                else AddForecasts(c);
            if (_components == 1 && motion.Count > 1) ForecastTable.LimitToDrive(_table, _points, speedFactor * motion.Velocity[0], motion.Interval, _limits);
        }

        // Adds one component of the weighted sum, within the limit of the distance.
        void AddForecasts(int component)
        {
            var (weights, factor) = (_weights[component].Values, _distance?.Factor ?? 1);
            for (var i = ForecasterSet.Line; i < weights.Length; i++)
                if (weights[i] != 0) _forecasters.AddTo(_table, component, i, weights[i] * factor, _points);
            if (factor < 1) _forecasters.AddTo(_table, component, ForecasterSet.Line, 1 - factor, _points);
        }
    }

    /// <summary>Limits the distance of the mixture's forecasts from the line through the two newest samples.</summary>
    /// <remarks>
    /// When a motion ends abruptly, polynomials through samples from before and after this moment overshoot by a multiple of their earlier errors. The
    /// line has the shortest window, so a forecast that is much further from the line than all earlier forecasts is moved towards it. The maximum
    /// also includes the distances of forecasts that were limited, so forecasts of a new kind of motion are limited for only a few samples.
    /// </remarks>
    sealed class DistanceLimit
    {
        /// <summary>Maximum distance as a multiple of the recent maximum. Values of 1 and 2.5 gave the same mean errors within 0.2 %.</summary>
        const double Growth = 1.5;

        double _max;

        /// <summary>Factor by which the distance from the line is multiplied until the next sample, 0 to 1.</summary>
        public double Factor { get; private set; } = 1;

        /// <summary>Adds the distance of the forecast that was computed after a sample.</summary>
        /// <param name="distance">Distance from the line after one horizon, m or rad.</param>
        /// <param name="forgettingFactor">Factor of the maximum since the previous sample, 0 to 1.</param>
        /// <param name="isUnconfirmed">Whether the sample may be wrong: the distance does not increase the maximum.</param>
        public void Add(double distance, double forgettingFactor, bool isUnconfirmed)
        {
            var max = Growth * _max;
            Factor = max > 0 && distance > max ? max / distance : 1;
            _max *= forgettingFactor;
            if (double.IsFinite(distance) && !isUnconfirmed) _max = Math.Max(_max, distance);
        }

        public void Clear() => (_max, Factor) = (0, 1);
    }
}
