using System;
using Nowpose.Prediction.Candidates;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>
    /// Forecasts by a mixture: the weighted sum of forecasts whose weights minimise its recent error. A candidate replaces the mixture while
    /// its error is clearly smaller.
    /// </summary>
    /// <remarks>
    /// No single forecaster is best for every motion: the paper's quadratic is better on clean swings, a straight line on many real machines.
    /// Each new sample is processed in three steps: it is compared with the forecasts that were made one horizon before it, the weights are solved
    /// from these errors, and the tables of all forecasts, one of which is displayed, are filled.
    /// </remarks>
    sealed class Mixer : Forecaster
    {
        /// <summary>
        /// Time constant of the forgetting factor of the weights, in s: with 10 or 40 s, the errors of joints change by at most 0.2 %; with 40 s, the
        /// errors of objects are 1.5 % larger.
        /// </summary>
        public const double TimeConstant = 20;

        /// <summary>
        /// Threshold for a first move, which is a motion much faster than the recent ones: minimum ratio of the squared displacement within one
        /// horizon to the mean square error of hold. For a motion that continues at constant speed, the ratio is 1. Without the rule, the errors on
        /// recordings are 3.9 % larger, and those of simulated motions 2.8 % smaller.
        /// </summary>
        public const double FirstMoveRatio = 30;

        /// <summary>
        /// Maximum age of a scored snapshot, in horizons; the mean sampling interval is added. An older snapshot was made before a pause of the
        /// samples.
        /// </summary>
        const double MaxAgeRatio = 1.5;

        readonly PredictionLimits _limits;
        readonly MixedForecasters _forecasters;
        readonly WeightSelector _weights;
        readonly (Forecaster Forecaster, CandidateGate Gate)[] _candidates;
        readonly ForecastSnapshots _snapshots;
        readonly double[] _errors;

        // The tables of all forecasts, which are valid only during a solve.
        readonly double[] _tables;

        // The displayed forecast.
        readonly double[] _section = new double[ForecastTable.Points];
        readonly int _points;

        /// <param name="limits">Limits of the drive.</param>
        /// <param name="parts">The parts of the mixer to use.</param>
        /// <param name="forecasters">Forecasters of the mixture, which other joints may use in turn.</param>
        /// <param name="candidates">Forecasters that may replace the mixture, each with the gate that decides when.</param>
        public Mixer(PredictionLimits limits, PredictionParts parts, MixedForecasters forecasters, (Forecaster Forecaster, CandidateGate Gate)[] candidates)
        {
            _limits = limits;
            _candidates = candidates;
            _points = ForecastTable.PointsUpTo(limits.HorizonCap);
            _forecasters = forecasters;
            _weights = new WeightSelector(_forecasters, parts);
            _errors = new double[_forecasters.Count];
            var forecasts = _forecasters.Count + 1 + candidates.Length;
            _tables = forecasters.TablesFor(forecasts);
            _snapshots = new ForecastSnapshots(forecasts);
            Reset();
        }

        public override int Samples => 2;

        public override double Span => ForecastTable.Span;

        // Order of the tables in a snapshot: forecasters, mixture, candidates.
        int Mixture => _forecasters.Count;

        int CandidateTable(int candidate) => Mixture + 1 + candidate;

        public override bool Solve(MotionState motion)
        {
            if (motion.IsNewest)
            {
                var forgettingFactor = Math.Exp(-motion.MeanInterval / TimeConstant);
                ScorePastForecasts(motion, forgettingFactor);
                _weights.Solve(motion, forgettingFactor);
                Forecast(motion, _snapshots.Append());
            }
            // A late sample changes the newest forecast, but not the weights.
            else if (_snapshots.Count > 0) Forecast(motion, _snapshots[_snapshots.Count - 1]);
            return motion.ConnectedSamples >= 2;
        }

        public override double At(double ahead) => new TableTime(ahead).Read(_section);

        public override void Reset()
        {
            foreach (var (forecaster, gate) in _candidates)
            {
                forecaster.Reset();
                gate.Reset();
            }
            _forecasters.Reset();
            _snapshots.Clear();
            _weights.Reset();
            Array.Clear(_section, 0, _section.Length);
        }

        // Fills all tables of a snapshot and selects the one that is displayed.
        void Forecast(MotionState motion, ForecastSnapshots.Snapshot snapshot)
        {
            snapshot.Time = motion.Samples.NewestTime;
            snapshot.Position = motion.Samples[0].Position;
            snapshot.ChangePoints = motion.ChangePoints.Count;
            snapshot.WasAtRest = motion.Rest.IsAtRest;
            snapshot.WasStill = motion.Rest.Standstill.Samples > 0;
            _forecasters.Fill(motion, _tables, _points);
            FillMixture(motion);
            snapshot.Store(_tables, _points, FillCandidates(motion) | (motion.ConnectedSamples < 2 ? 0 : 1u << Mixture));
            Array.Copy(_tables, Select(snapshot) * ForecastTable.Points, _section, 0, _points);
        }

        void FillMixture(MotionState motion)
        {
            var (tables, start, weights) = (_tables, Mixture * ForecastTable.Points, _weights.Values);
            Array.Clear(tables, start, _points);
            for (var i = MixedForecasters.Line; i < Mixture; i++)
            {
                var weight = weights[i];
                if (weight == 0) continue;
                for (int point = 0, from = i * ForecastTable.Points; point < _points; point++) tables[start + point] += weight * tables[from + point];
            }
            if (motion.ConnectedSamples >= 2) ForecastTable.Limit(tables, start, _points, motion.Speed, motion.Interval, _limits);
        }

        // Returns one bit per table that contains a candidate's forecast.
        uint FillCandidates(MotionState motion)
        {
            var filled = 0u;
            for (var i = 0; i < _candidates.Length; i++)
            {
                var (forecaster, table) = (_candidates[i].Forecaster, CandidateTable(i));
                if (!forecaster.Solve(motion)) continue;
                forecaster.Fill(_tables, table * ForecastTable.Points, _points);
                filled |= 1u << table;
            }
            return filled;
        }

        // Returns the table of the mixture, or of the candidate with the smallest error among those that may replace the mixture.
        int Select(ForecastSnapshots.Snapshot snapshot)
        {
            var (best, minRatio) = (Mixture, double.PositiveInfinity);
            for (var i = 0; i < _candidates.Length; i++)
            {
                if (!snapshot.HasForecast(CandidateTable(i))) continue;
                var ratio = _candidates[i].Gate.ErrorRatio(snapshot.WasStill);
                if (ratio < minRatio) (best, minRatio) = (CandidateTable(i), ratio);
            }
            return best;
        }

        // Compares the newest sample with forecasts that were made about one horizon before it: with the older snapshot around this time, and also
        // with the younger one if it is nearer and the joint is not at rest, where noise decides which one is nearer. The weights learn from one
        // snapshot. Candidates are scored with each of them, because there are few forecasts of candidates.
        void ScorePastForecasts(MotionState motion, double forgettingFactor)
        {
            var (now, horizon) = (motion.Samples.NewestTime, motion.Horizon);
            if (!_snapshots.TryFind(now - horizon, out var older, out var younger)) return;
            var isFromBeforePause = !(now - older.Time < MaxAgeRatio * horizon + motion.MeanInterval);
            var isYoungerNearer = younger != null && horizon - (now - younger.Time) < now - older.Time - horizon;
            if (isFromBeforePause) older = null;
            if (!isYoungerNearer || motion.Rest.IsAtRest) younger = null;
            if (older != null) ScoreCandidates(motion, older);
            if (younger != null) ScoreCandidates(motion, younger);
            if ((younger ?? older) != null) Learn(motion, younger ?? older, forgettingFactor);
        }

        // Scores each candidate against the mixture with the weights at the time of the snapshot. Candidates are also scored across a change point:
        // a repeated motion includes its stops.
        void ScoreCandidates(MotionState motion, ForecastSnapshots.Snapshot snapshot)
        {
            var ahead = motion.Samples.NewestTime - snapshot.Time;
            if (_candidates.Length == 0 || !IsInTable(ahead)) return;
            var (time, truth, threshold) = (new TableTime(ahead), motion.Samples[0].Position, _weights.Threshold);
            var mixtureError = Math.Min(Math.Abs(snapshot.At(Mixture, time) - truth), threshold);
            for (var i = 0; i < _candidates.Length; i++)
            {
                if (!snapshot.HasForecast(CandidateTable(i))) continue;
                var position = snapshot.At(CandidateTable(i), time);
                var displacement = Math.Max(Math.Abs(truth - snapshot.Position), Math.Abs(position - snapshot.Position));
                _candidates[i].Gate.Score(position - truth, mixtureError, Math.Min(displacement, threshold), snapshot.WasStill, motion.Samples.NewestTime);
            }
        }

        // Updates the weights with the errors of all forecasters. Errors across a change point are not used, because no forecaster can predict it.
        // Errors of forecasts from a single sample are not used either: all these forecasts are equal to the sample. Their errors are the largest
        // errors of a motion, so they would hide the differences between the forecasters for seconds.
        void Learn(MotionState motion, ForecastSnapshots.Snapshot snapshot, double forgettingFactor)
        {
            var ahead = motion.Samples.NewestTime - snapshot.Time;
            if (!snapshot.HasForecast(Mixture) || snapshot.ChangePoints != motion.ChangePoints.Count || !IsInTable(ahead)) return;
            var (time, truth, threshold) = (new TableTime(ahead), motion.Samples[0].Position, _weights.Threshold);
            for (var i = 0; i < Mixture; i++)
            {
                var error = snapshot.At(i, time) - truth;
                // The product of two larger errors would overflow.
                if (!(Math.Abs(error) < JointSample.MaxMagnitude)) return;
                _errors[i] = error > threshold ? threshold : error < -threshold ? -threshold : error;
            }
            _weights.Learn(_errors, snapshot.WasAtRest, forgettingFactor);
        }

        // To read a table, the point after the cell is also needed.
        bool IsInTable(double ahead) => ahead <= (_points < ForecastTable.Points ? _points - 2 : _points - 1) * ForecastTable.Step;
    }
}
