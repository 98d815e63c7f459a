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
        /// <summary>Maximum number of pending forecasts: half a second of samples at 180 Hz.</summary>
        const int Capacity = 96;

        /// <summary>
        /// Weight of the errors of an object's other components, relative to those of the component itself: all have the same kind of motion, but some
        /// may only have noise. With 1, the errors of real trackers are 2.5 % (position) and 4 % (rotation) larger; with 0, those of first turns are 4 %
        /// larger.
        /// </summary>
        const double OtherComponents = 0.3;

        // _mixture: start of the mixture's position in the positions for one time.
        readonly int _components, _mixture;
        readonly ForecasterSet _forecasters;
        readonly Candidate[] _candidates;
        readonly MixtureWeights[] _weights;

        // Forecasts that wait, the oldest first, and then free elements, the last used one first: its memory is still in the processor's cache. With 200
        // axes, a ring buffer takes 10 % more time per sample.
        readonly Expectation[] _pending = new Expectation[Capacity];
        readonly double[] _errors, _truth;
        int _count;

        /// <param name="weights">Weights of each component.</param>
        public PendingForecasts(int components, ForecasterSet forecasters, Candidate[] candidates, MixtureWeights[] weights)
        {
            (_components, _forecasters, _candidates, _weights) = (components, forecasters, candidates, weights);
            _mixture = forecasters.Count * components;
            for (var i = 0; i < Capacity; i++) _pending[i] = new Expectation(CandidateRow(candidates.Length));
            (_errors, _truth) = (new double[_mixture], new double[components]);
        }

        /// <summary>Distance of the newest forecast of the mixture from the line, in m or rad.</summary>
        public double DistanceFromLine { get; private set; }

        /// <summary>Adds the forecasts after the newest sample for the time of one horizon ahead.</summary>
        public void Add(MotionState motion)
        {
            var (expected, horizon) = (Append(), motion.Timing.Horizon);
            var (time, positions) = (new TableTime(horizon), expected.Positions);
            expected.Due = motion.NewestTime + horizon;
            expected.WasStill = motion.IsStill;
            for (var c = 0; c < _components; c++)
            {
                var (newest, sum) = (motion.Newest[c], 0.0);
                for (var i = 0; i < _forecasters.Count; i++)
                {
                    var forecast = _forecasters.At(i, time, c);
                    positions[i * _components + c] = newest + forecast;
                    sum += _weights[c].Values[i] * forecast;
                }
                positions[_mixture + c] = newest + sum;
                for (var i = 0; i < _candidates.Length; i++) positions[CandidateRow(i) + c] = newest + _candidates[i].At(time, c);
            }
            DistanceFromLine = Vectors.Distance(positions, _mixture, positions, ForecasterSet.Line * _components, _components);
        }

        /// <summary>
        /// Compares the forecasts for the interval before the newest sample with the line through both samples of the interval, and drops them.
        /// </summary>
        /// <param name="forgettingFactor">Forgetting factor of the weights for this interval.</param>
        public void Score(MotionState motion, double forgettingFactor)
        {
            var interval = motion.Interval;
            for (; _count > 0 && _pending[0].Due <= motion.NewestTime; DropFirst())
            {
                var expected = _pending[0];
                // In a long interval, a motion can start and end. After a gap, the interval is 0, but the list was cleared before.
                if (motion.Timing.IsAfterPause || !(interval < ForecastTable.Span) || expected.Due < motion.PreviousTime) continue;
                var fraction = (expected.Due - motion.PreviousTime) / interval;
                for (var c = 0; c < _components; c++) _truth[c] = motion.Newest[c] + motion.Displacements[_components + c] * (1 - fraction);
                ScoreForecasts(expected.Positions, forgettingFactor);
                ScoreCandidates(expected, motion.NewestTime);
            }
        }

        /// <summary>Drops the forecasts that were made from the sample before the newest, because its position is wrong.</summary>
        public void DropNewest() => _count = Math.Max(_count - 1, 0);

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

        // The errors of one component are adjacent.
        void ScoreForecasts(double[] positions, double forgettingFactor)
        {
            var (errors, differ) = (_errors, false);
            for (int c = 0, e = 0; c < _components; c++)
            {
                var (truth, line) = (_truth[c], positions[ForecasterSet.Line * _components + c]);
                for (var i = c; i < _mixture; i += _components, e++)
                {
                    errors[e] = positions[i] - truth;
                    if (!(Math.Abs(errors[e]) < JointSample.MaxMagnitude)) return;
                    differ |= positions[i] != line;
                }
            }
            // Equal forecasts, as from a rest without noise, do not show which forecaster is better. Their error at a start would only hide the
            // differences for seconds.
            if (!differ) return;
            for (var learning = 0; learning < _components; learning++)
                for (var c = 0; c < _components; c++)
                    _weights[learning].Learn(errors, c * _forecasters.Count, forgettingFactor, c == learning ? 1 : OtherComponents);
        }

        void ScoreCandidates(Expectation expected, double time)
        {
            var positions = expected.Positions;
            double mixture = ErrorOf(positions, _mixture), moved = ErrorOf(positions, ForecasterSet.Hold * _components);
            for (var i = 0; i < _candidates.Length; i++)
            {
                var row = CandidateRow(i);
                // Most candidates have no forecast.
                if (double.IsNaN(positions[row])) continue;
                var displacement = Math.Max(moved, Vectors.Distance(positions, ForecasterSet.Hold * _components, positions, row, _components));
                _candidates[i].Score(ErrorOf(positions, row), mixture, displacement, expected.WasStill, time);
            }
        }

        int CandidateRow(int candidate) => _mixture + (1 + candidate) * _components;

        double ErrorOf(double[] positions, int row) => Vectors.Distance(positions, row, _truth, 0, _components);

        /// <summary>Forecasts for one time.</summary>
        sealed class Expectation
        {
            public Expectation(int size) => Positions = new double[size];

            /// <summary>Time of the forecasts, in s.</summary>
            public double Due { get; set; }

            /// <summary>
            /// Positions by all forecasters, by the mixture without the limits of the displayed table, which candidates do not have either, and by the
            /// candidates; NaN for a candidate without a forecast. The components of each position are adjacent.
            /// </summary>
            public double[] Positions { get; }

            /// <summary>Whether the positions stood still when the forecasts were made.</summary>
            public bool WasStill { get; set; }
        }
    }
}
