using System;
using Nowpose.Prediction.Planning;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction
{
    /// <summary>Predicts one joint's position at times near its newest samples, usually ahead of them.</summary>
    /// <remarks>
    /// <see cref="Add"/> puts a sample into order and into the buffer, updates the state of the motion, and solves the forecaster for it. The
    /// curve through the samples and the forecast until the next sample are the section (Schnierle &amp; Röck 2022, Eq. 8). <see cref="At"/> reads the
    /// section, the plan if the joint follows one, and the remainder of the difference from the previous section. Times are seconds of control time since
    /// an epoch that the caller selects. It must be near the samples: within 1e6 s, rounding is negligible. Not thread-safe. Allocates nothing after
    /// construction.
    /// </remarks>
    public sealed class JointPredictor
    {
        /// <summary>One turn, in rad.</summary>
        const double Turn = 2 * Math.PI;

        readonly PredictionLimits _limits;
        readonly SectionBlend _blend;
        readonly PredictionPipeline<JointSample> _pipeline;
        readonly PlanFollower _plan;

        // Position of the newest sample, and the whole turns that unwrapping added to it, in rad. The sections have unwrapped positions.
        double _newest, _turns;

        internal JointPredictor(PredictionPipeline<JointSample> pipeline, PredictionLimits limits, double blend)
        {
            (_pipeline, _limits) = (pipeline, limits);
            (_blend, _plan) = (new SectionBlend(components: 1, blend, pipeline.MaxAhead), new PlanFollower(pipeline, limits));
        }

        /// <summary>Position of the newest sample, which a display without compensation shows; 0 before the first sample.</summary>
        public double Hold => _newest;

        /// <summary>Stamp of the newest sample as received, in s; negative infinity before the first sample.</summary>
        public double NewestTime => _pipeline.NewestStamp;

        /// <summary>Mean time from the newest sample to the display time, in s; forecasts are weighted for it.</summary>
        public double Horizon => _pipeline.Timing.Horizon;

        /// <summary>State of the motion after the newest sample.</summary>
        internal MotionState Motion => _pipeline.MotionOf(0);

        /// <summary>
        /// Number of times that the samples showed that their clock went back. All earlier samples are then discarded, and the added sample
        /// is the newest.
        /// </summary>
        public int Restarts => _pipeline.Restarts;

        /// <inheritdoc cref="PredictionPipeline{TSample}.IsNewestStampWrong"/>
        internal bool IsNewestStampWrong => _pipeline.IsNewestStampWrong;

        /// <summary>Adds a sample, and solves again if the used samples have changed. Samples may be added in any order.</summary>
        /// <param name="displayed">
        /// Last display time in s, on the clock of the samples. It determines the prediction horizon and the start of the blend to the new
        /// section. NaN if nothing is displayed.
        /// </param>
        /// <returns>
        /// <see cref="DropReason.DuplicateSample"/>, <see cref="DropReason.LateSample"/>, or <see cref="DropReason.None"/> for any other sample, also for one that
        /// thinning leaves out.
        /// A late sample, or a sample with an earlier time and another position, is used later if the next samples show that the clock went back.
        /// </returns>
        public DropReason Add(in JointSample sample, double displayed = double.NaN)
        {
            var reason = _pipeline.Receive(sample, out var hasRestarted);
            if (hasRestarted) Clear();
            // The display jumps back from a wrong stamp, because the blend would start from a value that was not displayed.
            if (IsNewestStampWrong) displayed = double.NaN;
            foreach (ref readonly var ready in _pipeline.Ready) Use(ready, displayed);
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
            return prediction.Kind == PredictionKind.None ? prediction : new JointPrediction(prediction.Position - _turns, prediction.Kind);
        }

        /// <summary>Returns the standard deviation of a prediction, in the samples' unit.</summary>
        /// <param name="time">See <see cref="At"/>.</param>
        /// <returns>
        /// NaN where it is unknown: for every predictor except <c>gp</c>, before the newest sample, beyond the horizon cap, and before
        /// the first comparison of a forecast with a sample. Plans and blending are not included.
        /// </returns>
        public double DeviationAt(double time) => _pipeline.DeviationAt(time);

        /// <summary>Replaces the plan of the control system.</summary>
        /// <param name="path">Null if the plan is cancelled.</param>
        /// <param name="start">Stamp of the plan, in s since the epoch of the samples.</param>
        /// <param name="displayed">See <see cref="Add"/>.</param>
        internal void Follow(JointPath path, double start, double displayed = double.NaN)
        {
            var shown = ShownAt(displayed);
            _plan.Follow(path, start, displayed);
            StartBlend(displayed, shown);
        }

        /// <summary>Returns the planned position, however far ahead, with the joint's delay and offset.</summary>
        /// <param name="time">See <see cref="At"/>.</param>
        /// <returns>False without a plan at that time, or if the joint does not follow it.</returns>
        internal bool TryPlan(double time, out double position)
        {
            position = 0;
            if (!_plan.IsFollowedAt(time)) return false;
            position = _limits.Clamp(_plan.At(time)) - _turns;
            return double.IsFinite(position);
        }

        /// <summary>Discards all samples and plans, after a restart of the control system or its clock.</summary>
        public void Reset()
        {
            _pipeline.Reset();
            Clear();
        }

        void Clear()
        {
            _newest = _turns = 0;
            _plan.Reset();
            _blend.Reset();
        }

        void Use(in JointSample sample, double displayed)
        {
            var isNewest = _pipeline.HasNewestOrder(sample);
            if (!_pipeline.Admit(sample)) return;
            var (shown, before) = (ShownAt(displayed), _pipeline.NewestTime);
            // Assumes the shorter way round between two samples more than half a turn apart.
            var turns = _limits.IsEndless && !_pipeline.IsEmpty ? WholeTurns(_newest + _turns - sample.Position) : 0;
            var unwrapped = turns == 0 ? sample
                : new JointSample(sample.Time, sample.Position + turns, sample.Order, sample.Velocity, sample.Acceleration);
            var hasChanged = _pipeline.Add(unwrapped, displayed);
            if (isNewest)
            {
                (_newest, _turns) = (sample.Position, turns);
                // A plan has the time of the control system, so the samples that follow it need no correction or thinning.
                _plan.Add(unwrapped, displayed);
            }
            if (hasChanged) _blend.StoreReplaced(displayed, before);
            if (hasChanged || _plan.HasPlan) StartBlend(displayed, shown);
        }

        // Returns the displayed position if the blend needs it.
        JointPrediction ShownAt(double displayed) => _blend.IsNeeded(displayed) ? UnwrappedAt(displayed) : default;

        void StartBlend(double displayed, in JointPrediction shown)
        {
            _blend.Stop();
            if (shown.Kind == PredictionKind.None) return;
            _blend.Start(displayed, stackalloc[] { shown.Position - UnwrappedAt(displayed).Position }, Motion);
        }

        // The displayed position, unwrapped for a continuous joint: the section, blended with the plan if there is one, and the remainder of the
        // residual.
        JointPrediction UnwrappedAt(double time)
        {
            var prediction = SectionAt(time);
            if (prediction.Kind == PredictionKind.None) return prediction;
            if (_plan.HasPlan) prediction = _plan.Blend(prediction, time, _blend.TimeConstant(_pipeline.Timing.MeanInterval));
            var position = prediction.Position + _blend.RemainderAt(time, 0);
            return new JointPrediction(_limits.Clamp(double.IsFinite(position) ? position : prediction.Position), prediction.Kind);
        }

        JointPrediction SectionAt(double time)
        {
            var place = _pipeline.PlaceOf(time);
            return place.Kind == PredictionKind.None ? default : new JointPrediction(_pipeline.At(place, 0, 0), place.Kind);
        }

        /// <summary>Returns the whole turns nearest to an angle, in rad.</summary>
        internal static double WholeTurns(double angle) => Turn * Math.Round(angle / Turn);
    }
}
