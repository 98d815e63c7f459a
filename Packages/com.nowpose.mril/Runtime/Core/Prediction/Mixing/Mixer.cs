using System;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>
    /// Weighted sum of forecasts with the weights that minimise its recent error. A candidate replaces it while the candidate is clearly
    /// better.
    /// </summary>
    /// <remarks>
    /// No single forecaster is best everywhere: the paper's quadratic is better on clean swings, a straight line on many real
    /// machines. Each sample gives the errors of the forecasts made one horizon earlier, from which the weights are solved, separately
    /// for rest and motion. Samples before a change point are not used, and a motion much faster than any before uses the prior weights.
    /// </remarks>
    sealed class Mixer : Forecaster
    {
        const int Hold = 0, Line = 1;

        /// <summary>Time constant of the forgetting factor, s.</summary>
        const double Memory = 20;

        /// <summary>
        /// Regularisation towards the prior, and of the weights of rest or motion towards the common ones (<see cref="MixtureWeights"/>): half
        /// or twice the values change the errors on recordings by less than half a percent.
        /// </summary>
        const double Regularisation = 0.2, ClassRegularisation = 0.5;

        /// <summary>Minimum square relative to the maximum recent one; smaller ones do not change the weights, since most come from rest.</summary>
        const double MinShareOfSquare = 1e-3;

        /// <summary>
        /// A squared displacement per horizon above this multiple of the mean square of hold counts as a motion not seen before.
        /// </summary>
        const double FirstMoveRatio = 30;

        /// <summary>Time after the start of such a motion during which a line predicts it, s.</summary>
        const double StartSeconds = 0.08;

        /// <summary>Rounding of times, s.</summary>
        const double Epsilon = 1e-6;

        /// <summary>Share of the memory that must be filled before outliers are detected.</summary>
        const double MinEvidence = 0.02;

        readonly PredictionLimits _limits;
        readonly PredictionParts _parts;
        readonly ForecasterTables _forecasters;
        readonly CandidateGate[] _candidates;
        readonly ForecastSnapshots _snapshots;
        readonly MixtureWeights _overall;
        readonly MixtureWeights _moving;
        readonly MixtureWeights _resting;
        readonly OutlierThreshold _outliers = new OutlierThreshold();
        readonly double[] _prior;
        readonly double[] _priorWhenReported;
        readonly double[] _line;
        readonly double[] _hold;
        readonly double[] _errors;
        readonly double[] _standstill = new double[ForecastTable.Points];
        readonly int _points;
        double[] _weights;

        // Forgetting factor of one sample.
        double _keeping;

        // The displayed forecast: one table of the newest snapshot.
        double[] _section;
        int _sectionStart;
        double _maxSquare;

        /// <param name="limits">Limits of the drive.</param>
        /// <param name="parts">The parts of the mixer to use.</param>
        /// <param name="mixed">Forecasters in addition to hold, which is always included; the first must be the line.</param>
        /// <param name="candidates">Forecasters that may replace the mixture.</param>
        public Mixer(PredictionLimits limits, PredictionParts parts, MixedForecaster[] mixed, CandidateGate[] candidates)
        {
            _limits = limits;
            _parts = parts;
            _candidates = candidates;
            // The spline reads two points beyond the horizon cap; later times are never displayed.
            _points = (int)Math.Min(ForecastTable.Points, Math.Ceiling(limits.HorizonCap / ForecastTable.Step) + 3);
            var count = Line + mixed.Length;
            var forecasters = new Forecaster[count];
            (_prior, _priorWhenReported, _line, _hold, _errors) =
                (new double[count], new double[count], new double[count], new double[count], new double[count]);
            _hold[Hold] = _line[Line] = 1;
            for (var i = 0; i < mixed.Length; i++)
                (forecasters[Line + i], _prior[Line + i], _priorWhenReported[Line + i]) = (mixed[i].Forecaster, mixed[i].Prior, mixed[i].PriorWhenReported);
            _forecasters = new ForecasterTables(forecasters, Line, _points, Has(PredictionParts.ChangePoints));
            Normalise(_prior);
            Normalise(_priorWhenReported);
            _overall = new MixtureWeights(Regularisation, _prior);
            _moving = new MixtureWeights(ClassRegularisation, _prior);
            _resting = new MixtureWeights(ClassRegularisation, _prior);
            _snapshots = new ForecastSnapshots(count + 1 + candidates.Length);
            Reset();
        }

        public override int Samples => 2;

        public override double Span => ForecastTable.Span;

        // If a forecaster is left out, the prior does not add up to one.
        static void Normalise(double[] weights)
        {
            var sum = 0.0;
            foreach (var weight in weights) sum += weight;
            for (var i = 0; i < weights.Length; i++) weights[i] = sum > 0 ? weights[i] / sum : i == Line ? 1 : 0;
        }

        bool Has(PredictionParts part) => (_parts & part) != 0;

        // Order of the tables in a snapshot: forecasters, mixture, candidates.
        int Mixture => _hold.Length;

        public override bool Solve(MotionState motion)
        {
            if (motion.IsNewest)
            {
                _keeping = Math.Exp(-motion.MeanInterval / Memory);
                Score(motion);
                _weights = Choose(motion);
                Forecast(motion, _snapshots.Append());
            }
            // A late sample changes the forecast, but not the weights.
            else if (_snapshots.Count > 0) Forecast(motion, _snapshots[_snapshots.Count - 1]);
            return motion.Connected >= 2;
        }

        public override double At(double ahead) => ForecastTable.Read(_section, _sectionStart, ahead);

        public override void Reset()
        {
            foreach (var candidate in _candidates) candidate.Reset();
            _forecasters.Reset();
            _snapshots.Clear();
            _outliers.Reset();
            _overall.Reset(_prior);
            _moving.Reset(_prior);
            _resting.Reset(_prior);
            (_section, _sectionStart) = (_standstill, 0);
            _weights = _prior;
            _maxSquare = 1e-12;
        }

        void Forecast(MotionState motion, ForecastSnapshots.Snapshot into)
        {
            into.Time = motion.Samples.NewestTime;
            into.Position = motion.Samples.NewestPosition;
            into.ChangePoints = motion.ChangePoints.Count;
            into.WasAtRest = motion.Rest.IsAtRest;
            into.WasStill = motion.Rest.StillSamples > 0;
            _forecasters.Fill(motion, into.Tables);
            FillMixture(motion, into.Tables);
            var best = Mixture;
            var minShare = double.PositiveInfinity;
            for (var i = 0; i < _candidates.Length; i++)
            {
                var (candidate, forecast) = (_candidates[i], Mixture + 1 + i);
                into.HasForecast(forecast) = candidate.Forecaster.Solve(motion);
                if (!into.HasForecast(forecast)) continue;
                candidate.Forecaster.Fill(into.Tables, forecast * ForecastTable.Points, _points);
                var share = candidate.ShareOfSquare(into.WasStill);
                if (share < minShare) (best, minShare) = (forecast, share);
            }
            (_section, _sectionStart) = (into.Tables, best * ForecastTable.Points);
        }

        void FillMixture(MotionState motion, double[] tables)
        {
            var start = Mixture * ForecastTable.Points;
            for (var point = start; point < start + _points; point++) tables[point] = 0;
            for (var i = Line; i < Mixture; i++)
            {
                var weight = _weights[i];
                if (weight == 0) continue;
                for (int point = 0, from = i * ForecastTable.Points; point < _points; point++) tables[start + point] += weight * tables[from + point];
            }
            if (motion.Connected >= 2) SpeedLimits.Apply(tables, start, _points, motion.Speed, motion.Interval, _limits);
        }

        // The weights are updated from the snapshot whose age is nearest to the horizon; at rest, where noise decides, from the next older
        // one. Candidates are scored by both, because they are rarely scored.
        void Score(MotionState motion)
        {
            var (now, horizon) = (motion.Samples.NewestTime, motion.Horizon);
            var older = _snapshots.Count - 1;
            while (older >= 0 && now - _snapshots[older].Time < horizon - Epsilon) older--;
            if (older < 0) return;
            var isOlderUsed = now - _snapshots[older].Time < 1.5 * horizon + motion.MeanInterval;
            var isYoungerNearer = older + 1 < _snapshots.Count && horizon - (now - _snapshots[older + 1].Time) < now - _snapshots[older].Time - horizon;
            var learned = false;
            if (isYoungerNearer && !motion.Rest.IsAtRest)
            {
                var ahead = now - _snapshots[older].Time;
                if (isOlderUsed && IsInTable(ahead)) ScoreCandidates(motion, _snapshots[older], new TableTime(ahead), Threshold);
                learned = Learn(motion, _snapshots[older + 1]);
            }
            else if (isOlderUsed) learned = Learn(motion, _snapshots[older]);
            _snapshots.Drop(older);
            if (learned) _overall.Solve(PriorNow(motion), 1 - _keeping);
        }

        bool Learn(MotionState motion, ForecastSnapshots.Snapshot snapshot)
        {
            var ahead = motion.Samples.NewestTime - snapshot.Time;
            if (!IsInTable(ahead)) return false;
            // The forecaster is not responsible for an error across a change point.
            var isOfOneMotion = snapshot.ChangePoints == motion.ChangePoints.Count;
            var time = new TableTime(ahead);
            var threshold = FillErrors(snapshot, time, motion.Samples.NewestPosition, isOfOneMotion, out var max);
            ScoreCandidates(motion, snapshot, time, threshold);
            if (!isOfOneMotion) return false;
            var square = max * max;
            _maxSquare = Math.Max(_maxSquare * _keeping, square);
            var isTelling = square > MinShareOfSquare * _maxSquare;
            if (isTelling) _overall.Learn(_errors, _keeping);
            if (snapshot.WasAtRest) _resting.Learn(_errors, _keeping);
            else if (isTelling) _moving.Learn(_errors, _keeping);
            return isTelling || snapshot.WasAtRest;
        }

        /// <param name="isOfOneMotion">Whether no change point lies between forecast and sample, so that the threshold adapts.</param>
        /// <param name="max">The larger error of hold and mixture, limited by the threshold.</param>
        /// <returns>The outlier threshold.</returns>
        double FillErrors(ForecastSnapshots.Snapshot snapshot, in TableTime time, double truth, bool isOfOneMotion, out double max)
        {
            var mixture = 0.0;
            for (var i = 0; i < Mixture; i++)
            {
                var error = snapshot.At(i, time) - truth;
                _errors[i] = error;
                mixture += _overall.Values[i] * error;
            }
            max = Math.Max(Math.Abs(_errors[Hold]), Math.Abs(mixture));
            var threshold = Threshold;
            if (double.IsPositiveInfinity(threshold)) return threshold;
            if (isOfOneMotion) _outliers.Add(UsualError, max);
            for (var i = 0; i < Mixture; i++)
                if (Math.Abs(_errors[i]) > threshold) _errors[i] = _errors[i] > 0 ? threshold : -threshold;
            max = Math.Min(max, threshold);
            return threshold;
        }

        void ScoreCandidates(MotionState motion, ForecastSnapshots.Snapshot snapshot, in TableTime time, double threshold)
        {
            var truth = motion.Samples.NewestPosition;
            var mixture = Math.Min(Math.Abs(snapshot.At(Mixture, time) - truth), threshold);
            for (var i = 0; i < _candidates.Length; i++)
            {
                var forecast = Mixture + 1 + i;
                if (!snapshot.HasForecast(forecast)) continue;
                var forecastPosition = snapshot.At(forecast, time);
                var displacement = Math.Max(Math.Abs(truth - snapshot.Position), Math.Abs(forecastPosition - snapshot.Position));
                _candidates[i].Score(forecastPosition - truth, mixture, Math.Min(displacement, threshold), snapshot.WasStill);
            }
        }

        // Reading a table also needs the point after the cell.
        bool IsInTable(double ahead) => ahead <= (_points < ForecastTable.Points ? _points - 2 : _points - 1) * ForecastTable.Step;

        double UsualError => Math.Sqrt(_overall.MeanSquare(Hold));

        double Threshold => _overall.Evidence < MinEvidence || !Has(PredictionParts.OutlierThreshold)
            ? double.PositiveInfinity : _outliers.Of(UsualError);

        double[] PriorNow(MotionState motion) => double.IsNaN(motion.Samples[0].Velocity + motion.Samples[0].Acceleration) ? _prior : _priorWhenReported;

        // Weights learned from noise at rest do not suit a first motion that is much faster.
        double[] Choose(MotionState motion)
        {
            var rest = motion.Rest;
            if (rest.IsOnlyNoise) return _hold;
            var heldSquare = _overall.MeanSquare(Hold);
            if (rest.IsAtRest) heldSquare = Math.Max(heldSquare, _resting.MeanSquare(Hold));
            var displacement = motion.Speed * motion.Horizon;
            if (displacement * displacement <= FirstMoveRatio * heldSquare || !Has(PredictionParts.FirstMoves))
            {
                if (!Has(PredictionParts.RestWeights)) return _overall.Values;
                var weights = rest.IsAtRest ? _resting : _moving;
                weights.Solve(_overall.Values, 1 - _keeping);
                return weights.Values;
            }
            var sinceStart = motion.Samples.NewestTime - motion.Start;
            return sinceStart < Math.Max(StartSeconds, 1.01 * motion.MeanInterval) + 1e-4 ? _line : PriorNow(motion);
        }
    }
}
