using System;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>Compares the newest samples with the history at a lag, and shifts the lag to the best fit.</summary>
    /// <remarks>Lags are in grid steps of the history, with fractions.</remarks>
    sealed class MotionOverlay
    {
        /// <summary>
        /// Approximate maximum number of compared samples, which limits the time per sample: each search compares them at several lags. Of 24
        /// samples, for example, every fifth is compared. With 8, the errors change by at most 0.1 %.
        /// </summary>
        const int ComparedSamples = 5;

        /// <summary>Number of Gauss-Newton steps. With one step, the errors of simulated motions are 1.0 % larger.</summary>
        const int Refinements = 2;

        readonly MotionHistory _history;

        // The compared samples, newest first: grid index, position, and distance from the history at the last comparison. Components are adjacent.
        readonly double[] _indices = new double[ComparedSamples + 1];
        readonly double[] _positions, _distances;
        int _count;

        // The history covers all compared samples at lags above the minimum and up to the maximum.
        double _minLag, _maxLag;

        // Gauss-Newton step from the lag of the last comparison.
        double _step;

        public MotionOverlay(MotionHistory history)
        {
            _history = history;
            (_positions, _distances) = (new double[_indices.Length * history.Components], new double[_indices.Length * history.Components]);
        }

        /// <summary>Mean square of the samples' distances from the history, after <see cref="Compare"/>.</summary>
        public double MeanSquare { get; private set; }

        /// <summary>Returns the mean distance of the newest two samples from the history in a component, after <see cref="Compare"/>.</summary>
        public double OffsetOf(int component) =>
            _count > 1 ? (_distances[component] + _distances[_history.Components + component]) / 2 : _distances[component];

        /// <summary>Sets the samples to compare with the history.</summary>
        /// <param name="count">Number of newest samples.</param>
        public void Take(MotionState motion, int count)
        {
            _count = 0;
            var (stride, n) = (1 + (count - 1) / ComparedSamples, _history.Components);
            for (var age = 0; age < count; age += age == 0 ? 1 : stride)
            {
                _indices[_count] = _history.IndexOf(motion.TimeAt(age));
                for (var c = 0; c < n; c++) _positions[_count * n + c] = motion.PositionAt(age, c);
                _count++;
            }
            (_minLag, _maxLag) = (_indices[0] - _history.End, _indices[_count - 1] - _history.First);
        }

        /// <summary>Returns the lag at which the samples fit best.</summary>
        /// <param name="lag">Lag found by <see cref="LagSearch"/>.</param>
        /// <param name="minLag">Minimum lag, so that the history after a match covers a whole forecast table.</param>
        public double Find(double lag, int minLag)
        {
            for (var i = 0; i < Refinements && Compare(lag); i++) lag = Math.Max(lag - _step, minLag);
            return lag;
        }

        /// <summary>Compares the samples with the history at a lag.</summary>
        /// <returns>False if the history does not cover the lag.</returns>
        public bool Compare(double lag)
        {
            MeanSquare = double.PositiveInfinity;
            _step = 0;
            if (!(lag > _minLag && lag <= _maxLag)) return false;
            var (points, n, positions, distances) = (_history.Points, _history.Components, _positions, _distances);
            double sum = 0, pull = 0, stiffness = 0;
            for (int k = 0, at = 0; k < _count; k++)
            {
                var index = _indices[k] - lag;
                var cell = (long)index;
                var f = index - cell;
                for (int c = 0, i = _history.PlaceOf(cell - 1); c < n; c++, i++, at++)
                {
                    double p0 = points[i], p1 = points[i + n], p2 = points[i + 2 * n], p3 = points[i + 3 * n];
                    // The same Catmull-Rom spline as in MotionHistory.At, and its derivative.
                    double first = p2 - p0, second = 2 * p0 - 5 * p1 + 4 * p2 - p3, third = 3 * (p1 - p2) + p3 - p0;
                    var error = positions[at] - p1 - 0.5 * f * (first + f * (second + f * third));
                    var speed = 0.5 * (first + f * (2 * second + 3 * f * third));
                    sum += error * error;
                    pull += error * speed;
                    stiffness += speed * speed;
                    distances[at] = error;
                }
            }
            MeanSquare = sum / _count;
            if (stiffness > 0) _step = pull > stiffness ? 1 : pull < -stiffness ? -1 : pull / stiffness;
            return true;
        }
    }
}
