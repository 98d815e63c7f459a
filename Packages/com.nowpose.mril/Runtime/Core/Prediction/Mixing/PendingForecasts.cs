using System;
using Nowpose.Prediction.Candidates;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>
    /// Forecasts that wait for the sample at their time. Its position shows the error of each forecast, from which the weights of the mixture and the gates
    /// of the candidates learn.
    /// </summary>
    sealed class PendingForecasts
    {
        /// <summary>Maximum interval in which samples are interpolated to score a forecast, s. In a longer one, a motion can start and end.</summary>
        const double MaxInterval = 0.5;

        /// <summary>Errors above this, in m or rad, are not scored: their squares would remain in every mean.</summary>
        const double MaxError = 1e9;

        /// <summary>Maximum difference of forecasts that counts as rounding, in m or rad.</summary>
        const double Rounding = 1e-9;

        /// <summary>Maximum number of pending forecasts: half a second of samples at 180 Hz.</summary>
        const int Capacity = 96;

        const int Line = ForecasterSet.Line;

        readonly int _components;
        readonly ForecasterSet _forecasters;
        readonly Candidate[] _candidates;
        readonly MixtureWeights _weights;

        // Forecasts that wait, the oldest first, and then free elements, the last used one first: its memory is still in the processor's cache. With 200
        // axes, a ring buffer takes 10 % more time per sample.
        readonly Expectation[] _pending = new Expectation[Capacity];
        readonly double[] _errors, _truth;
        int _count;

        public PendingForecasts(int components, ForecasterSet forecasters, Candidate[] candidates, MixtureWeights weights)
        {
            (_components, _forecasters, _candidates, _weights) = (components, forecasters, candidates, weights);
            for (var i = 0; i < Capacity; i++) _pending[i] = new Expectation(components, forecasters.Count, candidates.Length);
            (_errors, _truth) = (new double[forecasters.Count], new double[components]);
        }

        /// <summary>Adds the forecasts after the newest sample for the time of one horizon ahead.</summary>
        /// <returns>Distance of the mixture from the line at that time, m or rad.</returns>
        public double Add(MotionState motion)
        {
            var (expected, horizon, squares) = (Append(), motion.Timing.Horizon, 0.0);
            var time = new TableTime(horizon);
            expected.Due = motion.NewestTime + horizon;
            expected.WasStill = motion.StillSamples > 0;
            for (var c = 0; c < _components; c++)
            {
                var (sum, line) = (0.0, _forecasters.At(Line, time, c));
                for (var i = 0; i < _errors.Length; i++)
                {
                    var forecast = _forecasters.At(i, time, c);
                    expected.Forecasts[i * _components + c] = motion.Newest[c] + forecast;
                    sum += _weights.Values[i] * forecast;
                }
                expected.Mixture[c] = motion.Newest[c] + sum;
                squares += (sum - line) * (sum - line);
            }
            for (var i = 0; i < _candidates.Length; i++) expected.HasCandidate[i] = _candidates[i].TryForecast(time, motion, expected.Candidates[i]);
            return Math.Sqrt(squares);
        }

        /// <summary>
        /// Compares the forecasts for the interval before the newest sample with the line through both samples of the interval, and drops them.
        /// </summary>
        /// <param name="forgettingFactor">Forgetting factor of the weights for this interval.</param>
        /// <returns>Whether the weights have learned.</returns>
        public bool Score(MotionState motion, double forgettingFactor)
        {
            var (interval, hasLearned) = (motion.Timing.Interval, false);
            for (; _count > 0 && _pending[0].Due <= motion.NewestTime; DropFirst())
            {
                var expected = _pending[0];
                if (!(interval < MaxInterval) || expected.Due < motion.PreviousTime) continue;
                var fraction = (expected.Due - motion.PreviousTime) / interval;
                for (var c = 0; c < _components; c++) _truth[c] = motion.Previous[c] + (motion.Newest[c] - motion.Previous[c]) * fraction;
                hasLearned |= ScoreForecasts(expected, forgettingFactor);
                ScoreCandidates(expected, motion.NewestTime);
            }
            return hasLearned;
        }

        public void Clear() => _count = 0;

        Expectation Append()
        {
            if (_count == Capacity) DropFirst();
            return _pending[_count++];
        }

        void DropFirst()
        {
            var dropped = _pending[0];
            Array.Copy(_pending, 1, _pending, 0, --_count);
            _pending[_count] = dropped;
        }

        bool ScoreForecasts(Expectation expected, double forgettingFactor)
        {
            var (forecasts, differ) = (expected.Forecasts, false);
            for (var i = 0; i < forecasts.Length; i += _components)
            {
                if (!(Vectors.Distance(forecasts, i, _truth, 0, _components) < MaxError)) return false;
                differ |= Vectors.Distance(forecasts, i, forecasts, Line * _components, _components) > Rounding;
            }
            // From a rest without noise, all forecasts are equal. Their error at a start would hide the differences between the forecasters for seconds.
            if (!differ) return false;
            for (var c = 0; c < _components; c++)
            {
                for (var i = 0; i < _errors.Length; i++) _errors[i] = forecasts[i * _components + c] - _truth[c];
                _weights.Learn(_errors, forgettingFactor);
            }
            return true;
        }

        void ScoreCandidates(Expectation expected, double time)
        {
            var error = Vectors.Distance(expected.Mixture, _truth);
            for (var i = 0; i < _candidates.Length; i++)
            {
                if (!expected.HasCandidate[i]) continue;
                var forecast = expected.Candidates[i];
                var displacement = Math.Max(DistanceFromHold(expected, _truth), DistanceFromHold(expected, forecast));
                _candidates[i].Score(Vectors.Distance(forecast, _truth), error, displacement, expected.WasStill, time);
            }
        }

        double DistanceFromHold(Expectation expected, double[] position) =>
            Vectors.Distance(expected.Forecasts, ForecasterSet.Hold * _components, position, 0, _components);

        /// <summary>Forecasts for one time. The components of each position are adjacent.</summary>
        sealed class Expectation
        {
            public Expectation(int components, int forecasts, int candidates)
            {
                (Forecasts, Mixture) = (new double[forecasts * components], new double[components]);
                (Candidates, HasCandidate) = (new double[candidates][], new bool[candidates]);
                for (var i = 0; i < candidates; i++) Candidates[i] = new double[components];
            }

            /// <summary>Time of the forecasts, in s.</summary>
            public double Due { get; set; }

            public double[] Forecasts { get; }

            /// <summary>Weighted sum of the forecasts, without the limits of the displayed table, which candidates do not have either.</summary>
            public double[] Mixture { get; }

            public double[][] Candidates { get; }

            public bool[] HasCandidate { get; }

            /// <summary>Whether the positions stood still when the forecasts were made.</summary>
            public bool WasStill { get; set; }
        }
    }
}
