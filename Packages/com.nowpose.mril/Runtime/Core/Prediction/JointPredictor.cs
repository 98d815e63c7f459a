using System;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.Planning;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction
{
    /// <summary>Outcome of adding a sample to a predictor.</summary>
    public enum SampleOutcome
    {
        /// <summary>The newest sample.</summary>
        Accepted,

        /// <summary>Overtaken by newer samples. It takes its place among them when the next sample arrives.</summary>
        Late,

        /// <summary>
        /// Dropped: a sample with the same time (within 1 µs) arrived before. It is used all the same if the next ones show that the
        /// clock went back.
        /// </summary>
        Duplicate,

        /// <summary>Dropped: older than all samples that the prediction uses, with the same exception.</summary>
        TooOld,

        /// <summary>The clock of the samples went back. All samples before are discarded, and this one is the newest.</summary>
        StartedAnew
    }

    /// <summary>Predicts one joint's position at a time near its newest samples, usually ahead of them.</summary>
    /// <remarks>
    /// A sample that arrives in order passes the buffer and is solved for by the forecaster; its forecast until the next sample is the section
    /// (Schnierle &amp; Röck 2022, Eq. 8), and a new section is blended with what was displayed. Times are seconds of control time since an
    /// epoch the caller chooses near by (within 1e6 s costs no accuracy that matters). One thread at a time. Nothing allocates
    /// after construction.
    /// </remarks>
    public sealed class JointPredictor
    {
        /// <summary>
        /// Greatest time constant of the blend, as a share of the sampling interval: residuals of several sections add up, and beyond a
        /// fifth the RMS error grows by more than 5 % (display.md).
        /// </summary>
        const double MaxShareOfInterval = 0.2;

        /// <summary>
        /// A larger difference between two sections, relative to the greatest speed times the age of the section, is not blended: it comes
        /// from a joint that was set elsewhere or an angle that wrapped, and blended it would look like a motion. A prediction for a
        /// joint that reversed errs by 2, polynomials overshoot that by half and more.
        /// </summary>
        const double MaxError = 4;

        /// <summary>
        /// Time constant with which the section changes from the newest sample to a forecast that does not pass through it, s: short
        /// against every latency worth compensating.
        /// </summary>
        const double SeamTimeConstant = 0.005;

        /// <summary>A larger displacement overflows when squared, which would stay in every running mean.</summary>
        const double MaxDisplacement = 1e50;

        readonly PredictionLimits _limits;
        readonly double _timeConstant;
        readonly ArrivalOrder _arrivals;
        readonly SampleBuffer _buffer;
        readonly MotionState _motion;
        readonly Forecaster _forecaster;
        readonly bool _interpolates;
        readonly PlanFollower _plan = new PlanFollower();
        bool _isSolved;
        double _seam;

        // Difference of the section before to the newest one at the moment displayed last; it decays from then on.
        double _residual, _residualFrom, _residualTimeConstant;
        double _lastDisplayed, _sectionOf;

        /// <param name="forecaster">Used by this joint only.</param>
        /// <param name="kept">Samples kept for it.</param>
        /// <param name="parts">
        /// How samples are treated; without interpolation the forecaster is used before the newest sample too, as in the paper.
        /// </param>
        internal JointPredictor(Forecaster forecaster, int kept, PredictionParts parts, PredictionLimits limits, double blend)
        {
            if (!(blend >= 0) || double.IsPositiveInfinity(blend))
                throw new ArgumentOutOfRangeException(nameof(blend), blend, "seconds, 0 or more");
            _limits = limits ?? throw new ArgumentNullException(nameof(limits));
            _forecaster = forecaster;
            _timeConstant = blend;
            _arrivals = new ArrivalOrder(limits.IsEndless);
            _buffer = new SampleBuffer(
                kept, limits.IsEndless, (parts & PredictionParts.StampCorrection) != 0, (parts & PredictionParts.Thinning) != 0);
            _motion = new MotionState(_buffer.History, limits);
            _interpolates = (parts & PredictionParts.Interpolation) != 0;
            Reset();
        }

        /// <summary>The newest sample's position, what a display without compensation shows; 0 before the first.</summary>
        public double Hold => _buffer.NewestPosition;

        /// <summary>Stamp of the newest sample, uncorrected, s; negative infinity before the first.</summary>
        public double NewestTime => _buffer.NewestTime;

        /// <summary>Mean time from the newest sample to what is displayed, for which forecasts are weighed, s.</summary>
        public double Horizon => _motion.Horizon;

        /// <summary>Takes a sample in any order, and solves again when the samples have changed.</summary>
        /// <param name="displayed">
        /// The latest moment displayed so far, in the time of the samples, s: the prediction horizon follows from it, and the new section is
        /// blended from there. NaN where nothing is displayed.
        /// </param>
        public SampleOutcome Add(in JointSample sample, double displayed = double.NaN)
        {
            var outcome = _arrivals.Add(sample, _buffer.History.Oldest);
            if (outcome == SampleOutcome.StartedAnew) StartAnew();
            foreach (ref readonly var ready in _arrivals.Ready) Take(ready, displayed);
            return outcome;
        }

        /// <summary>The position at a time; never NaN: at worst the newest sample's, held. Does not change the state.</summary>
        /// <returns>
        /// <see cref="PredictionKind.None"/> with position 0 before the first sample. Of an endless joint, in the newest sample's turn;
        /// beyond π where the joint goes on beyond it.
        /// </returns>
        public JointPrediction At(double time)
        {
            var prediction = UnwrappedAt(time);
            return prediction.Kind == PredictionKind.None ? prediction : new JointPrediction(prediction.Position - _buffer.Shift, prediction.Kind);
        }

        /// <summary>Standard deviation of a prediction, in the samples' unit.</summary>
        /// <param name="time">As in <see cref="At"/>.</param>
        /// <returns>
        /// NaN where it is unknown: for every predictor except <c>gp</c>, before the newest sample, beyond the horizon cap, and before
        /// the first comparison of a forecast with a sample. Plans and blending are not included.
        /// </returns>
        public double DeviationAt(double time)
        {
            var ahead = time - _buffer.History.NewestTime;
            return _isSolved && ahead >= 0 && ahead <= _limits.HorizonCap ? _forecaster.DeviationAt(ahead) : double.NaN;
        }

        /// <summary>Takes a plan of the control system in place of the one before.</summary>
        /// <param name="path">Null when what was planned is off.</param>
        /// <param name="start">The plan's stamp, s since the epoch of the samples.</param>
        /// <param name="displayed">As in <see cref="Add"/>.</param>
        internal void Follow(PlannedPath path, double start, double displayed = double.NaN)
        {
            var shown = ShownAt(displayed);
            if (path == null) _plan.Drop();
            else Plan(path, start, displayed);
            Carry(displayed, shown);
        }

        /// <summary>Forgets all samples and plans, for a restart of the control system or its clock.</summary>
        public void Reset()
        {
            _arrivals.Clear();
            StartAnew();
        }

        void StartAnew()
        {
            Forget();
            _plan.Reset();
            _lastDisplayed = double.NaN;
            _sectionOf = double.NegativeInfinity;
        }

        void Take(in JointSample sample, double displayed)
        {
            var isNewest = _buffer.IsNewer(sample);
            if (!(Math.Abs(sample.Position - Hold) < MaxDisplacement))
            {
                if (!isNewest) return;
                Forget();
            }
            var shown = ShownAt(displayed);
            var (before, newest) = (NewestTime, _buffer.History.NewestTime);
            var hasChanged = _buffer.Add(sample);
            if (isNewest) _plan.Add(sample.Time, sample.Position + _buffer.Shift);
            if (hasChanged)
            {
                // With several samples between two frames, the displayed section is the one before the first of them.
                if (displayed != _lastDisplayed) (_lastDisplayed, _sectionOf) = (displayed, before);
                _motion.Take(_buffer.History.NewestTime > newest, displayed);
                Solve();
            }
            if (hasChanged || _plan.HasPlan) Carry(displayed, shown);
        }

        void Plan(PlannedPath path, double start, double displayed)
        {
            // A plan whose first set-point comes later leads there from where the joint is when it begins.
            var here = _plan.HasPlan && _plan.IsFollowedAt(start, NewestTime) ? _plan.At(start) : SectionAt(start).Position;
            // A plan gives an endless joint's angle in one turn; the samples are unwrapped.
            var turns = _limits.IsEndless ? SampleBuffer.WholeTurns(Hold + _buffer.Shift - path.FirstPosition) : 0;
            var from = path.First <= 0 ? path.FirstPosition : here - _plan.Offset - turns;
            _plan.Follow(path, start, from, turns, double.IsNaN(displayed) ? double.NegativeInfinity : displayed, NewestTime);
        }

        void Forget()
        {
            _buffer.Clear();
            _motion.Reset();
            _forecaster.Reset();
            _isSolved = false;
            _seam = _residual = 0;
        }

        void Solve()
        {
            _isSolved = _forecaster.Solve(_motion);
            _seam = _isSolved && _interpolates ? _forecaster.At(0) : 0;
        }

        // Needed only where sections are blended.
        JointPrediction ShownAt(double displayed) => _timeConstant == 0 || double.IsNaN(displayed) ? default : UnwrappedAt(displayed);

        double TimeConstant => Math.Min(_timeConstant, MaxShareOfInterval * _motion.MeanInterval);

        // What remained of the residual before is part of the displayed position, and so of the new residual.
        void Carry(double displayed, in JointPrediction shown)
        {
            _residual = 0;
            if (shown.Kind == PredictionKind.None) return;
            var timeConstant = TimeConstant;
            var residual = shown.Position - UnwrappedAt(displayed).Position;
            if (!(timeConstant > 0) || !(Math.Abs(residual) <= MaxError * _motion.MaxSpeed * (displayed - _sectionOf))) return;
            (_residual, _residualFrom, _residualTimeConstant) = (residual, displayed, timeConstant);
        }

        JointPrediction UnwrappedAt(double time)
        {
            if (_buffer.History.Count == 0) return default;
            var section = SectionAt(time);
            var (position, kind) = (section.Position, section.Kind);
            if (_plan.HasPlan)
            {
                var newest = NewestTime;
                var share = _plan.ShareAt(time, newest, newest + _limits.HorizonCap, TimeConstant, out var holds);
                var planned = share > 0 ? position + share * (_plan.At(time) - position) : position;
                if (double.IsFinite(planned)) (position, kind) = (planned, holds ? PredictionKind.Planned : kind);
            }
            if (_residual != 0)
            {
                var blended = position + _residual * Math.Exp(-Math.Abs(time - _residualFrom) / _residualTimeConstant);
                if (double.IsFinite(blended)) position = blended;
            }
            return new JointPrediction(_limits.Clamp(position), kind);
        }

        JointPrediction SectionAt(double time)
        {
            var (newest, held) = (_buffer.History.NewestTime, _buffer.History.NewestPosition);
            var ahead = time - newest;
            if (_interpolates && ahead <= 0 && _motion.Connected > 1)
            {
                var curve = new SampleCurve(_buffer.History, _motion.Connected);
                return new JointPrediction(curve.At(Math.Max(time, curve.Start)), time < curve.Start ? PredictionKind.Held : PredictionKind.Interpolated);
            }
            var kind = ahead <= 0 ? PredictionKind.Interpolated : PredictionKind.Predicted;
            var furthest = Math.Min(_limits.HorizonCap, _forecaster.Span);
            if (ahead > furthest) (ahead, kind) = (furthest, PredictionKind.Held);
            // Before its oldest sample a section extrapolates as wildly as after its newest one.
            else if (ahead < 0 && !double.IsPositiveInfinity(_limits.HorizonCap) && ahead < Oldest) (ahead, kind) = (Oldest, PredictionKind.Held);
            if (!_isSolved || double.IsNaN(time)) return new JointPrediction(held, PredictionKind.Held);
            var position = held + _forecaster.At(ahead);
            if (_seam != 0) position -= _seam * Math.Exp(-ahead / SeamTimeConstant);
            // Overflow must not reach a transform.
            return double.IsFinite(position) ? new JointPrediction(position, kind) : new JointPrediction(held, PredictionKind.Held);
        }

        // Time of the oldest sample of the section relative to the newest, s; not positive.
        double Oldest
        {
            get
            {
                var oldest = 0.0;
                for (var age = 1; age < Math.Min(_motion.Connected, _forecaster.Samples); age++)
                    oldest = Math.Min(oldest, _buffer.History[age].Time - _buffer.History.NewestTime);
                return oldest;
            }
        }
    }
}
