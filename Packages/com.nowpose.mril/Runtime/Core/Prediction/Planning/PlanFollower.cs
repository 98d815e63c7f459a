using System;

namespace Nowpose.Prediction.Planning
{
    /// <summary>Computes a joint's position from its plan, with the lag and offset of its samples. Detects whether it follows the plan.</summary>
    /// <remarks>Allocates nothing after construction; one thread. Times are seconds since the epoch of the samples.</remarks>
    sealed class PlanFollower
    {
        /// <summary>Number of consistent samples in motion after which a plan that was not followed is used again.</summary>
        const int AgreementsToReturn = 5;

        /// <summary>Standstill at the plan's end after which samples replace the plan, in s.</summary>
        const double Settling = 0.1;

        readonly PlanLag _lag = new PlanLag();
        ActivePlan _current, _next;
        int _agreements = AgreementsToReturn;

        /// <summary>Replaces the plan: from the new plan's start on if it is in the future, otherwise at once.</summary>
        /// <param name="start">Stamp of the plan, in s.</param>
        /// <param name="from">As in <see cref="ActivePlan"/>.</param>
        /// <param name="turns">As in <see cref="ActivePlan"/>.</param>
        /// <param name="now">The last displayed moment, in s.</param>
        /// <param name="newest">Time of the newest sample, in s.</param>
        public void Follow(PlannedPath path, double start, double from, double turns, double now, double newest)
        {
            var before = PlanAt(start + _lag.Lag);
            var plan = new ActivePlan(path, start, from, turns, IsFollowedAt(start + _lag.Lag, newest) ? before.Since : start);
            if (!_next.IsNone && _next.Start <= now - _lag.Lag) _current = _next;
            _next = plan;
            if (_current.IsNone || plan.Start <= now - _lag.Lag) (_current, _next) = (plan, default);
            _lag.Begin(plan.Range);
        }

        /// <summary>Drops the plan.</summary>
        public void Drop() => _current = _next = default;

        public void Reset()
        {
            Drop();
            _lag.Reset();
            _agreements = AgreementsToReturn;
        }

        /// <summary>Compares a sample with the plan.</summary>
        public void Add(double time, double position)
        {
            var (plan, at) = (PlanAt(time), time - _lag.Lag);
            if (plan.IsNone || at < plan.Start || at > plan.End + Settling) return;
            var difference = position - plan.At(at, out var velocity) - _lag.Offset;
            var verdict = _lag.Add(time, difference, velocity, plan.Range);
            if (verdict == PlanVerdict.NotFollowed) _agreements = 0;
            else if (verdict == PlanVerdict.Followed && _agreements < AgreementsToReturn) _agreements++;
        }

        /// <summary>Returns whether the plan determines the joint's position at a time.</summary>
        /// <param name="newest">Time of the newest sample: once there are samples after the plan's end, the plan is not used.</param>
        /// <returns>False without a plan at that time, or the joint does not follow it.</returns>
        public bool IsFollowedAt(double time, double newest)
        {
            var (plan, at) = (PlanAt(time), time - _lag.Lag);
            if (plan.IsNone || _agreements < AgreementsToReturn || at < plan.Start) return false;
            return at <= plan.End || (plan.EndsAtRest && newest - _lag.Lag < plan.End + Settling);
        }

        /// <summary>
        /// Share of the plan in the displayed position: it rises from 0 to 1 after the plan's start and falls after its end.
        /// </summary>
        /// <param name="newest">Time of the newest sample.</param>
        /// <param name="lastTime">Time after which the samples are too old for any plan.</param>
        /// <param name="timeConstant">Time constant of the rise and fall, in s; 0 for at once.</param>
        /// <param name="holds">Whether the plan determines the displayed position.</param>
        public double ShareAt(double time, double newest, double lastTime, double timeConstant, out bool holds)
        {
            holds = time <= lastTime && IsFollowedAt(time, newest);
            if (holds) return timeConstant > 0 ? 1 - Math.Exp(-(time - PlanAt(time).Since - _lag.Lag) / timeConstant) : 1;
            if (_current.IsNone || timeConstant == 0) return 0;
            var end = Math.Min(lastTime, PlanAt(time).End + _lag.Lag);
            return time > end && IsFollowedAt(end, newest) ? Math.Exp(-(time - end) / timeConstant) : 0;
        }

        /// <summary>
        /// Returns the plan's position, clamped to its start and end. Call it only while there is a plan.
        /// </summary>
        public double At(double time) => PlanAt(time).At(time - _lag.Lag, out _) + _lag.Offset;

        /// <summary>Constant distance of the joint from its plan, in rad or m.</summary>
        public double Offset => _lag.Offset;

        public bool HasPlan => !_current.IsNone;

        ActivePlan PlanAt(double time) => !_next.IsNone && time - _lag.Lag >= _next.Start ? _next : _current;
    }
}
