using System;

namespace Nowpose.Prediction.Planning
{
    /// <summary>Shows a joint where the control system means it to be, as long as it says so and the joint follows; else predicts.</summary>
    /// <remarks>
    /// The choice between plan and prediction is made for the newest moment asked for, and kept for earlier ones: so who blends one
    /// into the other can ask what the one now chosen says of the moment shown before.
    /// </remarks>
    public sealed class PlannedPredictor : IJointPredictor
    {
        readonly IJointPredictor _inner;
        readonly PredictionLimits _limits;
        readonly PlanFollower _plan = new PlanFollower();
        double _asked = double.NegativeInfinity;
        bool _isPlanned;

        /// <param name="inner">Says where the joint is without a plan.</param>
        /// <param name="limits">
        /// Position limits; and the horizon cap, for a plan says nothing of a joint of which no samples come any more.
        /// </param>
        public PlannedPredictor(IJointPredictor inner, PredictionLimits limits)
        {
            _inner = inner ?? throw new ArgumentNullException(nameof(inner));
            _limits = limits ?? throw new ArgumentNullException(nameof(limits));
        }

        /// <inheritdoc/>
        public double Hold => _inner.Hold;

        /// <inheritdoc/>
        public double NewestTime => _inner.NewestTime;

        /// <summary>Takes a plan in place of the one before, from its start on.</summary>
        /// <param name="start">The plan's stamp, s since the epoch of the samples.</param>
        public void Follow(PlannedPath path, double start)
        {
            if (path == null) throw new ArgumentNullException(nameof(path));
            // A plan whose first set-point comes later leads there from where the joint is when it begins.
            var from = path.First <= 0 ? path.FirstPosition
                : _plan.HasPlan && _plan.IsFollowedAt(start, NewestTime) ? _plan.At(start) : _inner.At(start).Position;
            _plan.Follow(new ActivePlan(path, start, from), _asked);
        }

        /// <summary>What was planned is off.</summary>
        public void DropPlan() => _plan.Drop();

        /// <inheritdoc/>
        public SampleOutcome Add(in JointSample sample)
        {
            var outcome = _inner.Add(sample);
            if (outcome == SampleOutcome.Accepted) _plan.Add(sample.Time, sample.Position);
            return outcome;
        }

        /// <inheritdoc/>
        public JointPrediction At(double time)
        {
            var prediction = _inner.At(time);
            if (prediction.Kind == PredictionKind.None) return prediction;
            if (!(time < _asked))
            {
                _asked = time;
                _isPlanned = time - NewestTime <= _limits.HorizonCap && _plan.IsFollowedAt(time, NewestTime);
            }
            if (!_isPlanned || !_plan.HasPlan) return prediction;
            var planned = _plan.At(time);
            return double.IsFinite(planned) ? new JointPrediction(_limits.Clamp(planned), PredictionKind.Planned) : prediction;
        }

        /// <inheritdoc/>
        public void Reset()
        {
            _inner.Reset();
            _plan.Reset();
            _asked = double.NegativeInfinity;
            _isPlanned = false;
        }
    }
}
