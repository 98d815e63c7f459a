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

        readonly PlanFilter _filter = new PlanFilter();
        ActivePlan _current, _next;
        int _agreements = AgreementsToReturn;

        /// <summary>Estimated delay of the joint behind its plan, in s.</summary>
        public double Delay => _filter.Delay;

        /// <summary>Estimated offset of the joint from its plan, in rad or m.</summary>
        public double Offset => _filter.Offset;

        public bool HasPlan => !_current.IsNone;

        /// <summary>Replaces the plan at the start of the new plan, or at once if this start is not in the future.</summary>
        /// <param name="start">Stamp of the plan, in s.</param>
        /// <param name="from">See <see cref="ActivePlan"/>.</param>
        /// <param name="turns">See <see cref="ActivePlan"/>.</param>
        /// <param name="displayed">Last display time, in s; NaN if nothing is displayed.</param>
        /// <param name="newest">Time of the newest sample, in s.</param>
        public void Replace(JointPath path, double start, double from, double turns, double displayed, double newest)
        {
            var now = displayed > newest ? displayed : newest;
            var before = PlanAt(start + _filter.Delay);
            var plan = new ActivePlan(path, start, from, turns, IsFollowedAt(start + _filter.Delay, newest) ? before.Since : start);
            if (!_next.IsNone && _next.Start <= now - _filter.Delay) _current = _next;
            _next = plan;
            if (_current.IsNone || plan.Start <= now - _filter.Delay) (_current, _next) = (plan, default);
            _filter.Start(plan.Range);
        }

        /// <summary>Drops the current and the next plan.</summary>
        public void Drop() => _current = _next = default;

        public void Reset()
        {
            Drop();
            _filter.Reset();
            _agreements = AgreementsToReturn;
        }

        /// <summary>Compares a sample with the plan.</summary>
        public void Add(double time, double position)
        {
            var plan = PlanAt(time);
            if (plan.IsNone) return;
            var at = time - _filter.Delay;
            if (at < plan.Start || at > plan.End + Settling) return;
            var difference = position - plan.At(at, out var velocity) - _filter.Offset;
            var verdict = _filter.Add(time, difference, velocity, plan.Range);
            if (verdict == PlanVerdict.NotFollowed) _agreements = 0;
            else if (verdict == PlanVerdict.Followed && _agreements < AgreementsToReturn) _agreements++;
        }

        /// <summary>Returns whether the plan determines the joint's position at a given time.</summary>
        /// <param name="newest">
        /// Time of the newest sample. A plan that ends at rest is used after its end until a sample from more than 0.1 s after the end arrives.
        /// </param>
        /// <returns>False without a plan at that time, or if the joint does not follow the plan.</returns>
        public bool IsFollowedAt(double time, double newest)
        {
            var (plan, at) = (PlanAt(time), time - _filter.Delay);
            if (plan.IsNone || _agreements < AgreementsToReturn || at < plan.Start) return false;
            // The end plus the delay, minus the delay, differs from the end by rounding.
            return at - plan.End < JointSample.SameSeconds || (plan.EndsAtRest && newest - _filter.Delay < plan.End + Settling);
        }

        /// <summary>
        /// Returns the weight of the plan in the displayed position: it rises from 0 to 1 after the plan's start and falls to 0 after its end.
        /// </summary>
        /// <param name="newest">Time of the newest sample.</param>
        /// <param name="lastTime">Time after which the samples are too old for any plan.</param>
        /// <param name="timeConstant">Time constant of the rise and fall, in s; 0 for an immediate change.</param>
        /// <param name="isPlanned">Whether the plan determines the displayed position.</param>
        public double WeightAt(double time, double newest, double lastTime, double timeConstant, out bool isPlanned)
        {
            isPlanned = time <= lastTime && IsFollowedAt(time, newest);
            if (isPlanned) return timeConstant > 0 ? 1 - Math.Exp(-(time - PlanAt(time).Since - _filter.Delay) / timeConstant) : 1;
            if (_current.IsNone || timeConstant == 0) return 0;
            var end = Math.Min(lastTime, PlanAt(time).End + _filter.Delay);
            return time > end && IsFollowedAt(end, newest) ? Math.Exp(-(time - end) / timeConstant) : 0;
        }

        /// <summary>
        /// Returns the joint's position according to the plan, its delay and its offset. The position is constant before the plan's start and after
        /// its end. Call it only while there is a plan.
        /// </summary>
        public double At(double time) => PlanAt(time).At(time - _filter.Delay, out _) + _filter.Offset;

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
