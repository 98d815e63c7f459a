using System;

namespace Nowpose.Prediction.Planning
{
    /// <summary>
    /// Computes a joint's position from its plan, with the delay and the offset with which the joint follows the plan. Detects whether the joint
    /// follows.
    /// </summary>
    /// <remarks>Times are seconds since the epoch of the samples.</remarks>
    sealed class PlanFollower
    {
        /// <summary>
        /// Number of consistent samples in motion after which a plan that was not followed is used again: a few samples may agree by chance, when the
        /// joint crosses the plan.
        /// </summary>
        const int AgreementsToReturn = 5;

        /// <summary>
        /// Settling time after the end of a plan, in s, during which the drive still approaches its target. A plan that ends at rest is used until a
        /// sample from after this time arrives.
        /// </summary>
        const double Settling = 0.1;

        readonly PredictionPipeline<JointSample> _pipeline;
        readonly PredictionLimits _limits;
        readonly PlanFilter _filter = new PlanFilter();
        ActivePlan _current, _next;
        int _agreements = AgreementsToReturn;

        // A plan that arrived before the first sample. It starts with this sample, because the position of the joint is unknown before.
        JointPath _waitingPath;
        double _waitingStart;

        /// <param name="pipeline">The samples of the joint and their sections, unwrapped if the joint is continuous.</param>
        public PlanFollower(PredictionPipeline<JointSample> pipeline, PredictionLimits limits) => (_pipeline, _limits) = (pipeline, limits);

        public bool HasPlan => !_current.IsNone;

        /// <summary>Replaces the plan at the start of the new plan, or at once if this start is not in the future.</summary>
        /// <param name="path">Null if the plan is cancelled.</param>
        /// <param name="start">Stamp of the plan, in s.</param>
        /// <param name="displayed">Last display time, in s; NaN if nothing is displayed.</param>
        public void Follow(JointPath path, double start, double displayed)
        {
            (_waitingPath, _waitingStart) = (_pipeline.IsEmpty ? path : null, start);
            if (path == null) _current = _next = default;
            else if (!_pipeline.IsEmpty) Start(path, start, displayed);
        }

        public void Reset()
        {
            _current = _next = default;
            _waitingPath = null;
            _filter.Reset();
            _agreements = AgreementsToReturn;
        }

        /// <summary>Compares the newest sample with the plan, after the pipeline has added it.</summary>
        /// <param name="displayed">See <see cref="Follow"/>.</param>
        public void Add(in JointSample sample, double displayed)
        {
            if (_waitingPath != null) Start(_waitingPath, _waitingStart, displayed);
            _waitingPath = null;
            var (plan, at) = (PlanAt(sample.Time), sample.Time - _filter.Delay);
            if (plan.IsNone || at < plan.Start || at > plan.End + Settling) return;
            var difference = sample.Position - plan.At(at, out var velocity) - _filter.Offset;
            var verdict = _filter.Add(sample.Time, difference, velocity, plan.Range);
            if (verdict == PlanVerdict.NotFollowed) _agreements = 0;
            else if (verdict == PlanVerdict.Followed && _agreements < AgreementsToReturn) _agreements++;
        }

        /// <summary>
        /// Returns whether the plan determines the joint's position at a given time. A plan that ends at rest is used after its end until a sample
        /// from more than 0.1 s after the end arrives.
        /// </summary>
        /// <returns>False without a plan at that time, or if the joint does not follow the plan.</returns>
        public bool IsFollowedAt(double time)
        {
            var (plan, at) = (PlanAt(time), time - _filter.Delay);
            if (plan.IsNone || _agreements < AgreementsToReturn || at < plan.Start) return false;
            // The end plus the delay, minus the delay, differs from the end by rounding.
            return at - plan.End < JointSample.SameSeconds || (plan.EndsAtRest && _pipeline.NewestStamp - _filter.Delay < plan.End + Settling);
        }

        /// <summary>
        /// Returns the joint's position according to the plan, its delay and its offset. The position is constant before the plan's start and after
        /// its end. Call it only while there is a plan.
        /// </summary>
        public double At(double time) => PlanAt(time).At(time - _filter.Delay, out _) + _filter.Offset;

        /// <summary>Returns the displayed position at a given time: the section, blended with the plan.</summary>
        /// <param name="section">Position in the section.</param>
        /// <param name="timeConstant">Time constant of the blend, in s; 0 for an immediate change.</param>
        public JointPrediction Blend(in JointPrediction section, double time, double timeConstant)
        {
            var weight = WeightAt(time, timeConstant, out var isPlanned);
            var position = weight > 0 ? section.Position + weight * (At(time) - section.Position) : section.Position;
            return double.IsFinite(position) ? new JointPrediction(position, isPlanned ? PredictionKind.Planned : section.Kind) : section;
        }

        // Weight of the plan: it rises from 0 to 1 after the plan's start and falls to 0 after its end. Beyond the horizon cap, the samples are too
        // old for any plan.
        double WeightAt(double time, double timeConstant, out bool isPlanned)
        {
            var lastTime = _pipeline.NewestStamp + _limits.HorizonCap;
            isPlanned = time <= lastTime && IsFollowedAt(time);
            if (isPlanned) return timeConstant > 0 ? 1 - Math.Exp(-(time - PlanAt(time).Since - _filter.Delay) / timeConstant) : 1;
            if (timeConstant == 0) return 0;
            var end = Math.Min(lastTime, PlanAt(time).End + _filter.Delay);
            return time > end && IsFollowedAt(end) ? Math.Exp(-(time - end) / timeConstant) : 0;
        }

        void Start(JointPath path, double start, double displayed)
        {
            // A plan with a later first set-point starts from the position that the joint reaches, after its delay, at the plan's start.
            var reached = start + _filter.Delay;
            var isFollowed = IsFollowedAt(reached);
            var here = isFollowed ? At(reached) : _pipeline.At(_pipeline.PlaceOf(reached), 0, 0);
            // A plan contains a continuous joint's angle within one turn; the samples are unwrapped.
            var turns = _limits.IsEndless ? JointPredictor.WholeTurns(_pipeline.Newest.Position - path.FirstPosition) : 0;
            // A single sample from after the start shows where the joint is on its way to the first set-point; near this set-point, it does not
            // matter.
            var (first, newest) = (path.FirstPosition + turns + _filter.Offset, _pipeline.NewestStamp);
            var elapsed = newest - reached;
            if (_pipeline.MotionOf(0).Count == 1 && elapsed > 0 && elapsed < path.First)
                here = first + (here - first) * path.First / Math.Max(path.First - elapsed, path.First / 2);
            var from = path.First <= 0 ? path.FirstPosition : here - _filter.Offset - turns;
            var plan = new ActivePlan(path, start, from, turns, isFollowed ? PlanAt(reached).Since : start);

            var now = (displayed > newest ? displayed : newest) - _filter.Delay;
            if (!_next.IsNone && _next.Start <= now) _current = _next;
            _next = plan;
            if (_current.IsNone || plan.Start <= now) (_current, _next) = (plan, default);
            _filter.Start(plan.Range);
        }

        ActivePlan PlanAt(double time) => !_next.IsNone && time - _filter.Delay >= _next.Start ? _next : _current;
    }

    /// <summary>A path and its start time; <c>default</c> means that no plan is active.</summary>
    readonly struct ActivePlan
    {
        readonly JointPath _path;
        readonly double _from;
        readonly double _turns;

        /// <param name="start">Stamp of the plan, in s.</param>
        /// <param name="from">
        /// The joint's position at the start, in the same turn as the path. A plan whose first set-point is later starts from this position.
        /// </param>
        /// <param name="turns">Whole turns of a continuous joint that are added to the path's positions, rad.</param>
        /// <param name="since">See <see cref="Since"/>.</param>
        public ActivePlan(JointPath path, double start, double from, double turns, double since) =>
            (_path, Start, _from, _turns, Since) = (path, start, from, turns, since);

        public bool IsNone => _path == null;

        /// <summary>Start time in s.</summary>
        public double Start { get; }

        /// <summary>Time since which a plan has determined the displayed position without interruption, in s.</summary>
        public double Since { get; }

        /// <summary>End time in s.</summary>
        public double End => Start + _path.Last;

        public double Range => _path.Range + Math.Abs(_from - _path.FirstPosition);

        public bool EndsAtRest => _path.EndsAtRest;

        /// <summary>Returns the position at a given time; constant before the start and after the end.</summary>
        public double At(double time, out double velocity)
        {
            var x = time - Start;
            if (_path.First <= 0 || x >= _path.First) return _turns + _path.At(x, out velocity);
            var displacement = _path.FirstPosition - _from;
            velocity = x < 0 ? 0 : displacement / _path.First;
            return _turns + _from + displacement * Math.Max(x, 0) / _path.First;
        }
    }
}
