using System;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>
    /// A forecaster that is correct for some motions only, with the gate that decides when it replaces the mixture.
    /// </summary>
    sealed class Candidate
    {
        readonly Forecaster _forecaster;
        readonly CandidateGate _gate;
        bool _hasForecast;

        public Candidate(Forecaster forecaster, CandidateGate gate) => (_forecaster, _gate) = (forecaster, gate);

        /// <summary>
        /// Mean square error relative to that of the mixture (<see cref="CandidateGate.ErrorRatio"/>); infinite while the forecast must not replace the
        /// mixture.
        /// </summary>
        public double ErrorRatio { get; private set; } = double.PositiveInfinity;

        /// <summary>Adds a sample that is newer than all previous samples.</summary>
        public void Add(MotionState motion)
        {
            _hasForecast = _forecaster.Solve(motion);
            ErrorRatio = _hasForecast ? _gate.ErrorRatio(motion.IsStill) : double.PositiveInfinity;
        }

        /// <summary>Returns a component of the forecast, as in its table, relative to the newest sample; NaN without a forecast.</summary>
        public double At(in TableTime time, int component) => _hasForecast ? time.Read(_forecaster, component) : double.NaN;

        /// <summary>Fills a <see cref="ForecastTable"/> with the forecast, if there is one.</summary>
        /// <inheritdoc cref="Forecaster.Fill"/>
        public void Fill(double[] table, int points, int components) => _forecaster.Fill(table, 0, points, components);

        /// <inheritdoc cref="CandidateGate.Score"/>
        public void Score(double error, double mixtureError, double displacement, bool wasStill, double time) =>
            _gate.Score(error, mixtureError, displacement, wasStill, time);

        public void Reset()
        {
            _forecaster.Reset();
            _gate.Reset();
            (_hasForecast, ErrorRatio) = (false, double.PositiveInfinity);
        }
    }

    /// <summary>
    /// Decides when a candidate replaces the mixture: while the recent errors of the candidate are clearly smaller. A candidate is a forecaster that
    /// is correct for some motions only.
    /// </summary>
    /// <remarks>
    /// Compares sums of squares with a forgetting factor, separately for forecasts made at a standstill and in motion: the start of a motion is
    /// harder to predict than its continuation.
    /// </remarks>
    sealed class CandidateGate
    {
        /// <summary>
        /// Minimum mean square error of the mixture, relative to the mean square displacement. If the mixture is more accurate, a candidate cannot
        /// improve the forecast visibly, but can spoil it: without this minimum, the error on one conveyor was 2.1 times that of a line.
        /// </summary>
        const double MinMixtureRatio = 1e-5;

        /// <summary>
        /// Minimum number of scored forecasts before the candidate may replace the mixture, because a few forecasts may be correct by chance. With 6,
        /// the errors change by at most 0.1 %.
        /// </summary>
        const int MinScores = 3;

        /// <summary>
        /// Time constant of the forgetting factor, in s: a few samples, so that the gate closes soon after a repetition ends. With 0.5 s, the displayed tool of
        /// the virtual cell left a gripped workpiece by up to 2.3 mm; with 0.2 s, false repetitions double the rotation errors of vehicles.
        /// </summary>
        /// <remarks>
        /// In motion, a pause without scores counts as at most one time constant, so that the errors of the last motion are not forgotten before the next:
        /// if they were, conveyors that are switched at random times would have up to 1.2 times the error of a line. A pause at a standstill counts in full,
        /// because few forecasts of starts are scored: a false start would otherwise prevent the use of a candidate for many cycles.
        /// </remarks>
        const double TimeConstant = 0.3;

        readonly double _maxErrorRatio;
        readonly bool _trustsUntested;
        Record _moving, _still;

        /// <param name="maxErrorRatio">
        /// Maximum ratio, 0 to 1, of the candidate's mean square error to the mixture's mean square error at which the candidate is used in motion. From a
        /// standstill, its square applies: the start of one of several moves may be correct by chance.
        /// </param>
        /// <param name="trustsUntested">Whether the candidate is also used until enough forecasts are scored.</param>
        public CandidateGate(double maxErrorRatio, bool trustsUntested = false) => (_maxErrorRatio, _trustsUntested) = (maxErrorRatio, trustsUntested);

        /// <summary>
        /// Returns the candidate's sum of squared errors relative to that of the mixture; infinite while the candidate must not replace the
        /// mixture. A candidate that is used untested has its limit in motion, so that tested candidates with smaller errors precede it.
        /// </summary>
        /// <param name="isStill">Whether the joint stands still.</param>
        public double ErrorRatio(bool isStill)
        {
            ref var record = ref isStill ? ref _still : ref _moving;
            if (record.Scores < MinScores) return _trustsUntested ? _maxErrorRatio : double.PositiveInfinity;
            var maxRatio = isStill ? _maxErrorRatio * _maxErrorRatio : _maxErrorRatio;
            var isImprovable = record.Mixture > MinMixtureRatio * record.Displacement;
            return isImprovable && record.Candidate < maxRatio * record.Mixture ? record.Candidate / record.Mixture : double.PositiveInfinity;
        }

        /// <summary>Scores a forecast against the sample at the forecast time.</summary>
        /// <param name="error">Error of the candidate.</param>
        /// <param name="mixtureError">Error of the mixture.</param>
        /// <param name="displacement">The larger of the true and the forecast displacement.</param>
        /// <param name="wasStill">Whether the joint stood still when the forecast was made.</param>
        /// <param name="time">Time of the sample, in s.</param>
        public void Score(double error, double mixtureError, double displacement, bool wasStill, double time)
        {
            // At rest, every forecast is correct.
            if (displacement == 0) return;
            // An overflow must not enter the sums.
            if (!(error * error + mixtureError * mixtureError + displacement * displacement < double.PositiveInfinity)) return;
            ref var record = ref wasStill ? ref _still : ref _moving;
            // The stamp of the previous score may have been wrong.
            var elapsed = Math.Max(time - record.Time, 0) / TimeConstant;
            var forgettingFactor = record.Scores == 0 ? 0 : Math.Exp(-(wasStill ? elapsed : Math.Min(elapsed, 1)));
            record.Candidate = forgettingFactor * record.Candidate + error * error;
            record.Mixture = forgettingFactor * record.Mixture + mixtureError * mixtureError;
            record.Displacement = forgettingFactor * record.Displacement + displacement * displacement;
            record.Time = time;
            record.Scores = Math.Min(record.Scores, MinScores) + 1;
        }

        public void Reset() => _moving = _still = default;

        struct Record
        {
            public double Candidate, Mixture, Displacement, Time;
            public int Scores;
        }
    }
}
