using System;

namespace Nowpose.Prediction.Planning
{
    /// <summary>Where a joint is by its plan, as late and as far beside it as its samples say, and whether it follows at all.</summary>
    /// <remarks>Allocates nothing once made; one thread. Times are seconds since the epoch of the samples.</remarks>
    sealed class PlanFollower
    {
        /// <summary>Number of consistent samples in motion after which a plan that was not followed is used again.</summary>
        const int AgreementsToReturn = 5;

        /// <summary>Standstill at the plan's end after which samples replace the plan, s.</summary>
        const double Settling = 0.1;

        readonly PlanLag _lag = new PlanLag();
        ActivePlan _current, _next;
        int _agreements = AgreementsToReturn;

        /// <summary>Takes a plan in place of the one before: from its start on if that lies ahead, at once otherwise.</summary>
        /// <param name="start">The plan's stamp, s.</param>
        /// <param name="from">As in <see cref="ActivePlan"/>.</param>
        /// <param name="turns">As in <see cref="ActivePlan"/>.</param>
        /// <param name="now">The newest moment that was shown, s.</param>
        /// <param name="newest">Time of the newest sample, s.</param>
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

        /// <summary>Where the joint is by the plan.</summary>
        /// <param name="newest">Time of the newest sample: with samples from the plan's end, the plan has nothing more to say.</param>
        /// <returns>False when no plan holds then, or the joint does not follow it.</returns>
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
        /// <param name="lastTime">From then on the samples are too old for any plan.</param>
        /// <param name="timeConstant">In which the rest falls to 1/e, s; 0 for at once.</param>
        /// <param name="holds">Whether the plan is what is shown.</param>
        public double ShareAt(double time, double newest, double lastTime, double timeConstant, out bool holds)
        {
            holds = time <= lastTime && IsFollowedAt(time, newest);
            if (holds) return timeConstant > 0 ? 1 - Math.Exp(-(time - PlanAt(time).Since - _lag.Lag) / timeConstant) : 1;
            if (_current.IsNone || timeConstant == 0) return 0;
            var end = Math.Min(lastTime, PlanAt(time).End + _lag.Lag);
            return time > end && IsFollowedAt(end, newest) ? Math.Exp(-(time - end) / timeConstant) : 0;
        }

        /// <summary>
        /// The plan's position, before its start and after its end the one there; to be asked only while there is a plan.
        /// </summary>
        public double At(double time) => PlanAt(time).At(time - _lag.Lag, out _) + _lag.Offset;

        /// <summary>Constant distance of the joint from its plan, rad or m.</summary>
        public double Offset => _lag.Offset;

        public bool HasPlan => !_current.IsNone;

        ActivePlan PlanAt(double time) => !_next.IsNone && time - _lag.Lag >= _next.Start ? _next : _current;
    }
}
