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
        const int Hold = MixedForecasters.Hold, Line = MixedForecasters.Line;

        /// <summary>Time constant of the forgetting factor, s.</summary>
        public const double Memory = 20;

        /// <summary>
        /// Regularisation towards the prior, and of the weights of rest or motion towards the common ones (<see cref="MixtureWeights"/>): half
        /// or twice the values change the errors on recordings by less than half a percent.
        /// </summary>
        const double Regularisation = 0.2, ClassRegularisation = 0.5;

        /// <summary>
        /// Maximum error that is scored, as a multiple of hold's usual error, so that one wrong sample does not outweigh seconds of correct
        /// ones: with five, the error on one recording was 6 % larger. Larger errors that persist raise the usual error within seconds.
        /// </summary>
        const double OutlierThreshold = 8;

        /// <summary>
        /// A squared displacement per horizon above this multiple of the mean square of hold counts as a motion not seen before.
        /// </summary>
        public const double FirstMoveRatio = 30;

        /// <summary>Time after the start of such a motion during which a line predicts it, s.</summary>
        const double StartSeconds = 0.08;

        /// <summary>Share of the memory that must be filled before outliers are detected.</summary>
        const double MinEvidence = 0.02;

        readonly PredictionLimits _limits;
        readonly PredictionParts _parts;
        readonly MixedForecasters _forecasters;
        readonly CandidateGate[] _candidates;
        readonly ForecastSnapshots _snapshots;
        readonly MixtureWeights _overall;
        readonly MixtureWeights _moving;
        readonly MixtureWeights _resting;
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
            _forecasters = new MixedForecasters(mixed, Has(PredictionParts.ChangePoints));
            var count = _forecasters.Count;
            (_line, _hold, _errors) = (new double[count], new double[count], new double[count]);
            _hold[Hold] = _line[Line] = 1;
            _overall = new MixtureWeights(Regularisation, _forecasters.Prior);
            _moving = new MixtureWeights(ClassRegularisation, _forecasters.Prior);
            _resting = new MixtureWeights(ClassRegularisation, _forecasters.Prior);
            _snapshots = new ForecastSnapshots(count + 1 + candidates.Length);
            Reset();
        }

        public override int Samples => 2;

        public override double Span => ForecastTable.Span;

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

        public override double At(double ahead) => new TableTime(ahead).Read(_section, _sectionStart);

        public override void Reset()
        {
            foreach (var candidate in _candidates) candidate.Reset();
            _forecasters.Reset();
            _snapshots.Clear();
            _overall.Reset(_forecasters.Prior);
            _moving.Reset(_forecasters.Prior);
            _resting.Reset(_forecasters.Prior);
            (_section, _sectionStart) = (_standstill, 0);
            _weights = _forecasters.Prior;
        }

        void Forecast(MotionState motion, ForecastSnapshots.Snapshot into)
        {
            into.Time = motion.Samples.NewestTime;
            into.Position = motion.Samples.NewestPosition;
            into.ChangePoints = motion.ChangePoints.Count;
            into.WasAtRest = motion.Rest.IsAtRest;
            into.WasStill = motion.Rest.StillSamples > 0;
            _forecasters.Fill(motion, into.Tables, _points);
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
            if (motion.Connected >= 2) ForecastTable.Limit(tables, start, _points, motion.Speed, motion.Interval, _limits);
        }

        // The weights are updated from the snapshot whose age is nearest to the horizon; at rest, where noise decides, from the next older
        // one. Candidates are scored by both, because they are rarely scored.
        void Score(MotionState motion)
        {
            var (now, horizon) = (motion.Samples.NewestTime, motion.Horizon);
            var older = _snapshots.Count - 1;
            while (older >= 0 && now - _snapshots[older].Time < horizon - JointSample.SameSeconds) older--;
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
            if (learned) _overall.Solve(_forecasters.PriorFor(motion.Samples[0]), 1 - _keeping);
        }

        bool Learn(MotionState motion, ForecastSnapshots.Snapshot snapshot)
        {
            var ahead = motion.Samples.NewestTime - snapshot.Time;
            if (!IsInTable(ahead)) return false;
            var time = new TableTime(ahead);
            var threshold = Threshold;
            var areExact = FillErrors(snapshot, time, motion.Samples.NewestPosition, threshold);
            ScoreCandidates(motion, snapshot, time, threshold);
            // The forecasters are not responsible for an error across a change point. At rest, all are right.
            if (snapshot.ChangePoints != motion.ChangePoints.Count) return false;
            if (snapshot.WasAtRest) _resting.Learn(_errors, _keeping);
            if (areExact) return snapshot.WasAtRest;
            _overall.Learn(_errors, _keeping);
            if (!snapshot.WasAtRest) _moving.Learn(_errors, _keeping);
            return true;
        }

        // Errors count up to the threshold. Returns whether all are zero.
        bool FillErrors(ForecastSnapshots.Snapshot snapshot, in TableTime time, double truth, double threshold)
        {
            var areExact = true;
            for (var i = 0; i < Mixture; i++)
            {
                var error = snapshot.At(i, time) - truth;
                areExact &= error == 0;
                _errors[i] = error > threshold ? threshold : error < -threshold ? -threshold : error;
            }
            return areExact;
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

        double Threshold => _overall.Evidence < MinEvidence || !Has(PredictionParts.OutlierThreshold)
            ? double.PositiveInfinity : OutlierThreshold * Math.Sqrt(_overall.MeanSquare(Hold));

        // Weights learned from noise at rest do not suit a first motion that is much faster.
        double[] Choose(MotionState motion)
        {
            var rest = motion.Rest;
            if (rest.IsOnlyNoise) return _hold;
            var heldSquare = _overall.MeanSquare(Hold);
            var displacement = motion.Speed * motion.Horizon;
            if (displacement * displacement <= FirstMoveRatio * heldSquare || !Has(PredictionParts.FirstMoves))
            {
                if (!Has(PredictionParts.RestWeights)) return _overall.Values;
                var weights = rest.IsAtRest ? _resting : _moving;
                weights.Solve(_overall.Values, 1 - _keeping);
                return weights.Values;
            }
            var sinceStart = motion.Samples.NewestTime - motion.Start;
            return sinceStart < Math.Max(StartSeconds, 1.01 * motion.MeanInterval) + 1e-4 ? _line : _forecasters.PriorFor(motion.Samples[0]);
        }
    }
}
