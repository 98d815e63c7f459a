using System;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.Planning;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction
{
    /// <summary>Predicts one joint's position at times near its newest samples, usually ahead of them.</summary>
    /// <remarks>
    /// <see cref="Add"/> puts a sample into order and into the buffer, updates the state of the motion, and solves the forecaster for it. The
    /// forecast until the next sample is the section (Schnierle &amp; Röck 2022, Eq. 8). <see cref="At"/> reads the section, the plan if the joint
    /// follows one, and the remainder of the difference from the previous section. Times are seconds of control time since an epoch that the caller
    /// selects. It must be near the samples: within 1e6 s, rounding is negligible. Not thread-safe. Allocates nothing after construction.
    /// </remarks>
    public sealed class JointPredictor
    {
        /// <summary>
        /// Time constant with which the jump from the curve to the forecast decays, in s: short compared with any latency that is worth compensating.
        /// </summary>
        internal const double JumpTimeConstant = 0.005;

        readonly PredictionLimits _limits;
        readonly SectionBlend _blend;
        readonly ArrivalOrder<JointSample> _arrivals;
        readonly SampleBuffer _buffer;
        readonly MotionState _motion;
        readonly Forecaster _forecaster;
        readonly bool _interpolates;
        readonly PlanFollower _plan = new PlanFollower();
        bool _isSolved;

        // Time and position of the newest sample of the history, in which angles are unwrapped; negative infinity and 0 before the first sample.
        // A copy, because a frame would otherwise read the history, which is not in the processor's cache.
        double _newestTime, _newestPosition;

        // Jump from the end of the curve, which is the newest sample, to the forecast at that time. It is subtracted from the forecast and decays.
        double _jump;

        // Difference between the previous and the newest section at the last display time; 0 without blending.
        double _residual;

        /// <param name="forecaster">Forecaster of this joint only.</param>
        /// <param name="kept">Number of samples to keep.</param>
        /// <param name="parts">
        /// Parts of the pipeline to use. Without interpolation, the forecaster is also used before the newest sample, as in the paper.
        /// </param>
        internal JointPredictor(Forecaster forecaster, int kept, PredictionParts parts, PredictionLimits limits, double blend)
        {
            _limits = limits ?? throw new ArgumentNullException(nameof(limits));
            _forecaster = forecaster;
            _blend = new SectionBlend(blend);
            _arrivals = new ArrivalOrder<JointSample>(limits.IsEndless);
            _buffer = new SampleBuffer(
                kept, limits.IsEndless, (parts & PredictionParts.StampCorrection) != 0, (parts & PredictionParts.Thinning) != 0);
            _motion = new MotionState(_buffer.History, limits);
            _interpolates = (parts & PredictionParts.Interpolation) != 0;
            Reset();
        }

        /// <summary>Position of the newest sample, which a display without compensation shows; 0 before the first sample.</summary>
        public double Hold => _buffer.NewestPosition;

        /// <summary>Uncorrected stamp of the newest sample, in s; negative infinity before the first sample.</summary>
        public double NewestTime => _buffer.NewestStamp;

        /// <summary>Mean time from the newest sample to the display time, in s; forecasts are weighted for it.</summary>
        public double Horizon => _motion.Horizon;

        /// <summary>State of the motion after the newest sample.</summary>
        internal MotionState Motion => _motion;

        /// <summary>
        /// Number of times that the samples showed that their clock went back. All earlier samples are then discarded, and the added sample
        /// is the newest.
        /// </summary>
        public int Restarts => _arrivals.Restarts;

        /// <summary>Adds a sample, and solves again if the used samples have changed. Samples may be added in any order.</summary>
        /// <param name="displayed">
        /// Last display time in s, on the clock of the samples. It determines the prediction horizon and the start of the blend to the new
        /// section. NaN if nothing is displayed.
        /// </param>
        /// <returns>
        /// <see cref="DropReason.DuplicateSample"/>, <see cref="DropReason.LateSample"/>, or <see cref="DropReason.None"/> for any other sample.
        /// A late sample, or a sample with an earlier time and another position, is used later if the next samples show that the clock went back.
        /// </returns>
        public DropReason Add(in JointSample sample, double displayed = double.NaN)
        {
            var restarts = Restarts;
            // The oldest sample is not in the processor's cache, and only late samples are compared with it.
            var reason = _arrivals.Add(sample, _buffer.IsNewer(sample) ? double.NegativeInfinity : _buffer.History.Oldest);
            if (Restarts != restarts) Restart();
            foreach (ref readonly var ready in _arrivals.Ready) Use(ready, displayed);
            return reason;
        }

        /// <summary>
        /// Returns the position at a given time. Never NaN: the fallback is the newest sample's position. Does not change the state.
        /// </summary>
        /// <returns>
        /// <see cref="PredictionKind.None"/> with position 0 before the first sample. For a continuous joint, the angle is in the same turn as the
        /// newest sample and exceeds π if the joint moves beyond π.
        /// </returns>
        public JointPrediction At(double time)
        {
            var prediction = UnwrappedAt(time);
            return prediction.Kind == PredictionKind.None ? prediction : new JointPrediction(prediction.Position - _buffer.Shift, prediction.Kind);
        }

        /// <summary>Returns the standard deviation of a prediction, in the samples' unit.</summary>
        /// <param name="time">See <see cref="At"/>.</param>
        /// <returns>
        /// NaN where it is unknown: for every predictor except <c>gp</c>, before the newest sample, beyond the horizon cap, and before
        /// the first comparison of a forecast with a sample. Plans and blending are not included.
        /// </returns>
        public double DeviationAt(double time)
        {
            var ahead = time - _buffer.History.NewestTime;
            return _isSolved && ahead >= 0 && ahead <= _limits.HorizonCap ? _forecaster.DeviationAt(ahead) : double.NaN;
        }

        /// <summary>Replaces the plan of the control system.</summary>
        /// <param name="path">Null if the plan is cancelled.</param>
        /// <param name="start">Stamp of the plan, in s since the epoch of the samples.</param>
        /// <param name="displayed">See <see cref="Add"/>.</param>
        internal void Follow(PlannedPath path, double start, double displayed = double.NaN)
        {
            var shown = ShownAt(displayed);
            if (path == null) _plan.Drop();
            else StartPlan(path, start, displayed);
            StartBlend(displayed, shown);
        }

        /// <summary>Returns the planned position, however far ahead, with the joint's delay and offset.</summary>
        /// <param name="time">See <see cref="At"/>.</param>
        /// <returns>False without a plan at that time, or if the joint does not follow it.</returns>
        internal bool TryPlan(double time, out double position)
        {
            position = 0;
            if (_buffer.History.Count == 0 || !_plan.HasPlan || !_plan.IsFollowedAt(time, NewestTime)) return false;
            position = _limits.Clamp(_plan.At(time)) - _buffer.Shift;
            return double.IsFinite(position);
        }

        /// <summary>Discards all samples and plans, after a restart of the control system or its clock.</summary>
        public void Reset()
        {
            _arrivals.Clear();
            Restart();
        }

        void Restart()
        {
            Clear();
            _plan.Reset();
            _blend.Reset();
        }

        void Use(in JointSample sample, double displayed)
        {
            var isNewest = _buffer.IsNewer(sample);
            // Products of such displacements can overflow. If the sample is the newest, a new history starts with it; otherwise it is ignored.
            if (!(Math.Abs(sample.Position - Hold) < JointSample.MaxMagnitude))
            {
                if (!isNewest) return;
                Clear();
            }
            var shown = ShownAt(displayed);
            var (before, newest) = (NewestTime, _buffer.History.NewestTime);
            var hasChanged = _buffer.Add(sample);
            if (isNewest) _plan.Add(sample.Time, sample.Position + _buffer.Shift);
            if (hasChanged)
            {
                _blend.Replace(displayed, before);
                _motion.Add(_buffer.History.NewestTime > newest, displayed);
                Solve();
            }
            if (hasChanged || _plan.HasPlan) StartBlend(displayed, shown);
        }

        void StartPlan(PlannedPath path, double start, double displayed)
        {
            // A plan with a later first set-point starts from the joint's position at the plan's start.
            var here = _plan.HasPlan && _plan.IsFollowedAt(start, NewestTime) ? _plan.At(start) : SectionAt(start).Position;
            // A plan contains a continuous joint's angle within one turn; the samples are unwrapped.
            var turns = _limits.IsEndless ? SampleBuffer.WholeTurns(Hold + _buffer.Shift - path.FirstPosition) : 0;
            var from = path.First <= 0 ? path.FirstPosition : here - _plan.Offset - turns;
            _plan.Replace(path, start, from, turns, double.IsNaN(displayed) ? double.NegativeInfinity : displayed, NewestTime);
        }

        void Clear()
        {
            _buffer.Clear();
            _motion.Reset();
            _forecaster.Reset();
            _isSolved = false;
            (_newestTime, _newestPosition) = (double.NegativeInfinity, 0);
            _jump = _residual = 0;
        }

        void Solve()
        {
            (_newestTime, _newestPosition) = (_buffer.History.NewestTime, _buffer.History[0].Position);
            _isSolved = _forecaster.Solve(_motion);
            _jump = _isSolved && _interpolates ? _forecaster.At(0) : 0;
        }

        // Returns the displayed position if the blend needs it.
        JointPrediction ShownAt(double displayed) => _blend.IsNeeded(displayed) ? UnwrappedAt(displayed) : default;

        // The displayed position includes the remainder of the previous residual, so the new residual includes it too.
        void StartBlend(double displayed, in JointPrediction shown)
        {
            _residual = 0;
            if (shown.Kind == PredictionKind.None) return;
            var residual = shown.Position - UnwrappedAt(displayed).Position;
            if (_blend.TryStart(displayed, Math.Abs(residual), _motion.MaxSpeed, _motion.MeanInterval)) _residual = residual;
        }

        // The displayed position, unwrapped for a continuous joint: the section, blended with the plan if there is one, and the remainder of the
        // residual.
        JointPrediction UnwrappedAt(double time)
        {
            if (double.IsNegativeInfinity(_newestTime)) return default;
            var section = SectionAt(time);
            var prediction = _plan.HasPlan ? WithPlan(section, time) : section;
            var position = _residual == 0 ? prediction.Position : prediction.Position + _residual * _blend.RemainderAt(time);
            return new JointPrediction(_limits.Clamp(double.IsFinite(position) ? position : prediction.Position), prediction.Kind);
        }

        JointPrediction WithPlan(in JointPrediction section, double time)
        {
            var timeConstant = _blend.TimeConstant(_motion.MeanInterval);
            var weight = _plan.WeightAt(time, NewestTime, NewestTime + _limits.HorizonCap, timeConstant, out var holds);
            var position = weight > 0 ? section.Position + weight * (_plan.At(time) - section.Position) : section.Position;
            return double.IsFinite(position) ? new JointPrediction(position, holds ? PredictionKind.Planned : section.Kind) : section;
        }

        JointPrediction SectionAt(double time) =>
            _interpolates && time <= _newestTime && _motion.ConnectedSamples > 1 ? InterpolatedAt(time) : ForecastAt(time);

        JointPrediction InterpolatedAt(double time)
        {
            var curve = new SampleCurve<JointSample>(_buffer.History, component: 0, _motion.ConnectedSamples);
            return time < curve.Start ? new JointPrediction(curve.At(curve.Start), PredictionKind.Held)
                : new JointPrediction(curve.At(time), PredictionKind.Interpolated);
        }

        // The paper's polynomials are used before their newest sample too.
        JointPrediction ForecastAt(double time)
        {
            var hold = new JointPrediction(_newestPosition, PredictionKind.Held);
            if (!_isSolved || double.IsNaN(time)) return hold;
            var ahead = time - _newestTime;
            var kind = ahead <= 0 ? PredictionKind.Interpolated : PredictionKind.Predicted;
            var furthest = Math.Min(_limits.HorizonCap, _forecaster.Span);
            if (ahead > furthest) (ahead, kind) = (furthest, PredictionKind.Held);
            // A section is as inaccurate before its oldest sample as it is far beyond its newest sample, so its value at the oldest sample is held.
            else if (ahead < 0 && !double.IsPositiveInfinity(_limits.HorizonCap) && ahead < Start) (ahead, kind) = (Start, PredictionKind.Held);
            var position = hold.Position + _forecaster.At(ahead);
            if (_jump != 0) position -= _jump * Math.Exp(-ahead / JumpTimeConstant);
            // An overflow must not reach a transform.
            return double.IsFinite(position) ? new JointPrediction(position, kind) : hold;
        }

        // Start of the section relative to the newest sample, s; not positive.
        double Start => _buffer.History.StartOf(Math.Min(_motion.ConnectedSamples, _forecaster.Samples));
    }
}
