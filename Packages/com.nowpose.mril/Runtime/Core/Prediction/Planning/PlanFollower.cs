using System;

namespace Nowpose.Prediction.Planning
{
    /// <summary>Where a joint is by its plan, as late and as far beside it as its samples say, and whether it follows at all.</summary>
    /// <remarks>Allocates nothing once made; one thread. Times are seconds since the epoch of the samples.</remarks>
    sealed class PlanFollower
    {
        /// <summary>So many samples of it moving, none against it, bring a plan back that the joint did not follow.</summary>
        const int AgreementsToReturn = 5;

        /// <summary>How long samples have to stand still at the plan's end until they are a better basis than the plan, s.</summary>
        const double Settling = 0.1;

        readonly PlanLag _lag = new PlanLag();
        ActivePlan _current, _next;
        int _agreements = AgreementsToReturn;

        /// <summary>Takes a plan in place of the one before: from its start on if that lies ahead, at once otherwise.</summary>
        /// <param name="plan">With a path.</param>
        /// <param name="now">The newest moment that was shown, s.</param>
        public void Follow(in ActivePlan plan, double now)
        {
            if (!_next.IsNone && _next.Start <= now - _lag.Lag) _current = _next;
            _next = plan;
            if (_current.IsNone || plan.Start <= now - _lag.Lag) (_current, _next) = (plan, default);
            _lag.Begin(plan.Range);
        }

        /// <summary>What was planned is off.</summary>
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

        /// <summary>The plan's position, before its start and after its end the one there; to be asked only while there is a plan.</summary>
        public double At(double time) => PlanAt(time).At(time - _lag.Lag, out _) + _lag.Offset;

        public bool HasPlan => !_current.IsNone;

        ActivePlan PlanAt(double time) => !_next.IsNone && time - _lag.Lag >= _next.Start ? _next : _current;
    }
}
