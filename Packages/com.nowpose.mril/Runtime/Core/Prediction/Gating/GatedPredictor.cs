using System;

namespace Nowpose.Prediction.Gating
{
    /// <summary>Lets a predictor that is right only now and then speak only while it is, by its own record, clearly better.</summary>
    /// <remarks>
    /// Both forecast the sample one horizon ahead; when it comes, both are scored, forecasts made at rest and in motion
    /// apart: when a motion will start is another question than how it goes on. Allocates nothing once made.
    /// </remarks>
    public sealed class GatedPredictor : IJointPredictor
    {
        /// <summary>Squares below this share of the greatest lately are nothing: all are right about rest.</summary>
        const double LeastShareOfSquare = 1e-4;

        /// <summary>A newest way below this share of the greatest lately is rest.</summary>
        const double RestShare = 1e-3;

        const double Forgetting = 0.998;
        const double UsualKeeping = 0.98;

        readonly IJointPredictor _candidate;
        readonly IJointPredictor _fallback;
        readonly ForecastHorizon _horizon = new ForecastHorizon();
        readonly PendingForecasts _pending = new PendingForecasts();
        readonly OutlierBound _outliers = new OutlierBound();
        readonly ForecastRecord _moving;
        readonly ForecastRecord _resting;
        double _usualSquare;
        double _greatestSquare;
        double _greatestWay;
        bool _isAtRest;

        /// <param name="candidate">Says <see cref="PredictionKind.None"/> when it has nothing to say.</param>
        /// <param name="fallback">Speaks otherwise, and whenever in doubt.</param>
        /// <param name="shareOfSquare">The candidate's mean square must be below this share of the other's, 0 to 1.</param>
        /// <exception cref="ArgumentOutOfRangeException">The share is not between 0 and 1.</exception>
        public GatedPredictor(IJointPredictor candidate, IJointPredictor fallback, double shareOfSquare)
        {
            if (!(shareOfSquare > 0 && shareOfSquare <= 1))
                throw new ArgumentOutOfRangeException(nameof(shareOfSquare), shareOfSquare, "above 0, at most 1");
            _moving = new ForecastRecord(shareOfSquare, 10);
            _resting = new ForecastRecord(shareOfSquare, 12);
            _candidate = candidate ?? throw new ArgumentNullException(nameof(candidate));
            _fallback = fallback ?? throw new ArgumentNullException(nameof(fallback));
            Reset();
        }

        /// <inheritdoc/>
        public double Hold => _fallback.Hold;

        /// <inheritdoc/>
        public double NewestTime => _fallback.NewestTime;

        /// <summary>Whether the candidate speaks where it has something to say.</summary>
        public bool IsOpen => Record(_isAtRest).FavoursCandidate;

        /// <inheritdoc/>
        public SampleOutcome Add(in JointSample sample)
        {
            var timeBefore = NewestTime;
            var positionBefore = Hold;
            var outcome = _fallback.Add(sample);
            _candidate.Add(sample);
            if (outcome != SampleOutcome.Accepted) return outcome;
            if (!double.IsNegativeInfinity(timeBefore)) Score(timeBefore, positionBefore);
            Forecast();
            return outcome;
        }

        /// <inheritdoc/>
        public JointPrediction At(double time)
        {
            var fallback = _fallback.At(time);
            if (fallback.Kind == PredictionKind.None) return fallback;
            _horizon.Ask(time, time - NewestTime);
            if (!IsOpen) return fallback;
            var candidate = _candidate.At(time);
            return candidate.Kind == PredictionKind.None ? fallback : candidate;
        }

        /// <inheritdoc/>
        public void Reset()
        {
            _candidate.Reset();
            _fallback.Reset();
            _pending.Clear();
            _moving.Reset();
            _resting.Reset();
            _horizon.Reset();
            _outliers.Reset();
            _usualSquare = _greatestSquare = _greatestWay = 0;
            _isAtRest = true;
        }

        ForecastRecord Record(bool isAtRest) => isAtRest ? _resting : _moving;

        void Score(double timeBefore, double positionBefore)
        {
            var interval = NewestTime - timeBefore;
            _horizon.Sample(interval);
            var way = Math.Abs(Hold - positionBefore);
            _greatestWay = Math.Max(Forgetting * _greatestWay, way);
            _isAtRest = way <= RestShare * _greatestWay;
            while (_pending.TryTakeDue(NewestTime, out var forecast))
            {
                // A forecast for a time between two samples is judged by the line between them; mostly it is at the sample.
                var truth = Hold - (Hold - positionBefore) * Math.Min((NewestTime - forecast.Time) / interval, 1);
                Judge(forecast, truth);
            }
        }

        void Judge(in PendingForecasts.Forecast forecast, double truth)
        {
            var way = Math.Abs(truth - forecast.Held);
            var bound = _usualSquare > 0 ? _outliers.Of(Math.Sqrt(_usualSquare), way) : double.PositiveInfinity;
            var credited = Math.Min(way, bound);
            _usualSquare = _usualSquare > 0 ? UsualKeeping * _usualSquare + (1 - UsualKeeping) * credited * credited : credited * credited;
            var greatest = Math.Min(Math.Max(way, Math.Abs(forecast.Candidate - forecast.Held)), bound);
            _greatestSquare = Math.Max(Forgetting * _greatestSquare, greatest * greatest);
            if (greatest * greatest > LeastShareOfSquare * _greatestSquare)
                // An outlier of the fallback's proves nothing for the candidate; its own may well close the gate.
                Record(forecast.IsAtRest).Add(forecast.Candidate - truth, Math.Min(Math.Abs(forecast.Fallback - truth), bound));
        }

        void Forecast()
        {
            var intervals = Math.Max(1, Math.Round(_horizon.Seconds / _horizon.Interval));
            var time = NewestTime + intervals * _horizon.Interval;
            var candidate = _candidate.At(time);
            // Without a word it is neither right nor wrong: the other speaks.
            if (candidate.Kind == PredictionKind.None) return;
            _pending.Add(new PendingForecasts.Forecast(time, Hold, candidate.Position, _fallback.At(time).Position, _isAtRest));
        }
    }
}
