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
    /// machines. Each sample gives the errors of the forecasts made one horizon earlier, from which the weights are solved. Samples before
    /// a change point are not used.
    /// </remarks>
    sealed class Mixer : Forecaster
    {
        /// <summary>Time constant of the forgetting factor, s.</summary>
        public const double Memory = 20;

        /// <summary>
        /// A squared displacement per horizon above this multiple of the mean square of hold is a first move: a motion not seen recently.
        /// </summary>
        public const double FirstMoveRatio = 30;

        /// <summary>Maximum age of a scored snapshot relative to the horizon, plus one interval: older ones are from before a pause.</summary>
        const double MaxAgeRatio = 1.5;

        readonly PredictionLimits _limits;
        readonly MixedForecasters _forecasters;
        readonly AdaptiveWeights _weights;
        readonly CandidateGate[] _candidates;
        readonly ForecastSnapshots _snapshots;
        readonly double[] _errors;
        readonly double[] _standstill = new double[ForecastTable.Points];
        readonly int _points;

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
            _candidates = candidates;
            // The spline reads two points beyond the horizon cap; later times are never displayed.
            _points = (int)Math.Min(ForecastTable.Points, Math.Ceiling(limits.HorizonCap / ForecastTable.Step) + 3);
            _forecasters = new MixedForecasters(mixed, (parts & PredictionParts.ChangePoints) != 0);
            _weights = new AdaptiveWeights(_forecasters, parts);
            _errors = new double[_forecasters.Count];
            _snapshots = new ForecastSnapshots(_forecasters.Count + 1 + candidates.Length);
            Reset();
        }

        public override int Samples => 2;

        public override double Span => ForecastTable.Span;

        // Order of the tables in a snapshot: forecasters, mixture, candidates.
        int Mixture => _forecasters.Count;

        public override bool Solve(MotionState motion)
        {
            if (motion.IsNewest)
            {
                var forgettingFactor = Math.Exp(-motion.MeanInterval / Memory);
                Score(motion, forgettingFactor);
                _weights.Solve(motion, forgettingFactor);
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
            _weights.Reset();
            (_section, _sectionStart) = (_standstill, 0);
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
            var minRatio = double.PositiveInfinity;
            for (var i = 0; i < _candidates.Length; i++)
            {
                var (candidate, forecast) = (_candidates[i], Mixture + 1 + i);
                into.HasForecast(forecast) = candidate.Forecaster.Solve(motion);
                if (!into.HasForecast(forecast)) continue;
                candidate.Forecaster.Fill(into.Tables, forecast * ForecastTable.Points, _points);
                var ratio = candidate.ErrorRatio(into.WasStill);
                if (ratio < minRatio) (best, minRatio) = (forecast, ratio);
            }
            (_section, _sectionStart) = (into.Tables, best * ForecastTable.Points);
        }

        void FillMixture(MotionState motion, double[] tables)
        {
            var (start, weights) = (Mixture * ForecastTable.Points, _weights.Values);
            Array.Clear(tables, start, _points);
            for (var i = MixedForecasters.Line; i < Mixture; i++)
            {
                var weight = weights[i];
                if (weight == 0) continue;
                for (int point = 0, from = i * ForecastTable.Points; point < _points; point++) tables[start + point] += weight * tables[from + point];
            }
            if (motion.Connected >= 2) ForecastTable.Limit(tables, start, _points, motion.Speed, motion.Interval, _limits);
        }

        // The weights learn from the snapshot whose age is nearest to the horizon; at rest, where noise decides, from the older one.
        // Candidates are scored by both, because they are rarely scored.
        void Score(MotionState motion, double forgettingFactor)
        {
            var (now, horizon) = (motion.Samples.NewestTime, motion.Horizon);
            if (!_snapshots.TryFind(now - horizon, out var older, out var younger)) return;
            var isYoungerNearer = younger != null && horizon - (now - younger.Time) < now - older.Time - horizon;
            var learnsFromYounger = isYoungerNearer && !motion.Rest.IsAtRest;
            if (now - older.Time < MaxAgeRatio * horizon + motion.MeanInterval) Score(motion, older, forgettingFactor, !learnsFromYounger);
            if (learnsFromYounger) Score(motion, younger, forgettingFactor, true);
        }

        void Score(MotionState motion, ForecastSnapshots.Snapshot snapshot, double forgettingFactor, bool learns)
        {
            var ahead = motion.Samples.NewestTime - snapshot.Time;
            if (!IsInTable(ahead)) return;
            var (time, truth, threshold) = (new TableTime(ahead), motion.Samples.NewestPosition, _weights.Threshold);
            ScoreCandidates(snapshot, time, truth, threshold);
            // The forecasters are not responsible for an error across a change point.
            if (!learns || snapshot.ChangePoints != motion.ChangePoints.Count) return;
            for (var i = 0; i < Mixture; i++)
            {
                var error = snapshot.At(i, time) - truth;
                _errors[i] = error > threshold ? threshold : error < -threshold ? -threshold : error;
            }
            _weights.Learn(_errors, snapshot.WasAtRest, forgettingFactor);
        }

        // Compares each candidate with the mixture that was displayed, which had the weights of that time.
        void ScoreCandidates(ForecastSnapshots.Snapshot snapshot, in TableTime time, double truth, double threshold)
        {
            var mixtureError = Math.Min(Math.Abs(snapshot.At(Mixture, time) - truth), threshold);
            for (var i = 0; i < _candidates.Length; i++)
            {
                var forecast = Mixture + 1 + i;
                if (!snapshot.HasForecast(forecast)) continue;
                var position = snapshot.At(forecast, time);
                var displacement = Math.Max(Math.Abs(truth - snapshot.Position), Math.Abs(position - snapshot.Position));
                _candidates[i].Score(position - truth, mixtureError, Math.Min(displacement, threshold), snapshot.WasStill);
            }
        }

        // Reading a table also needs the point after the cell.
        bool IsInTable(double ahead) => ahead <= (_points < ForecastTable.Points ? _points - 2 : _points - 1) * ForecastTable.Step;
    }
}
