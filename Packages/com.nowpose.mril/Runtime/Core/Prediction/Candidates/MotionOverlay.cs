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

        // The compared samples, newest first: grid index, and position, whose components are adjacent.
        readonly double[] _indices = new double[ComparedSamples + 1];
        readonly double[] _positions;
        int _count;

        // Gauss-Newton step from the lag of the last comparison.
        double _step;

        public MotionOverlay(MotionHistory history)
        {
            _history = history;
            _positions = new double[_indices.Length * history.Components];
            Offsets = new double[history.Components];
        }

        /// <summary>Mean square of the samples' distances from the history, after <see cref="Compare"/>.</summary>
        public double MeanSquare { get; private set; }

        /// <summary>Mean distance of the newest two samples from the history in each component, after <see cref="Compare"/>.</summary>
        public double[] Offsets { get; }

        /// <summary>Sets the samples to compare with the history.</summary>
        /// <param name="count">Number of newest samples.</param>
        public void Take(MotionState motion, int count)
        {
            _count = 0;
            var (stride, n) = (1 + (count - 1) / ComparedSamples, _history.Components);
            for (var age = 0; age < count; age += age == 0 ? 1 : stride)
            {
                _indices[_count] = _history.IndexOf(motion.TimeAt(age));
                for (var c = 0; c < n; c++) _positions[_count * n + c] = motion.Newest[c] + motion.Displacements[age * n + c];
                _count++;
            }
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
            if (!_history.Covers(_indices[0] - lag) || !_history.Covers(_indices[_count - 1] - lag)) return false;
            var (points, n) = (_history.Points, _history.Components);
            double sum = 0, pull = 0, stiffness = 0;
            Array.Clear(Offsets, 0, n);
            for (int k = 0, at = 0; k < _count; k++, at += n)
            {
                var index = _indices[k] - lag;
                var cell = (long)index;
                var f = index - cell;
                int before = _history.PlaceOf(cell - 1), here = _history.PlaceOf(cell), next = _history.PlaceOf(cell + 1), after = _history.PlaceOf(cell + 2);
                for (var c = 0; c < n; c++)
                {
                    double p0 = points[before + c], p1 = points[here + c], p2 = points[next + c], p3 = points[after + c];
                    // The same Catmull-Rom spline as in MotionHistory.At, and its derivative.
                    double first = p2 - p0, second = 2 * p0 - 5 * p1 + 4 * p2 - p3, third = 3 * (p1 - p2) + p3 - p0;
                    var error = _positions[at + c] - p1 - 0.5 * f * (first + f * (second + f * third));
                    var speed = 0.5 * (first + f * (2 * second + 3 * f * third));
                    sum += error * error;
                    pull += error * speed;
                    stiffness += speed * speed;
                    if (k < 2) Offsets[c] += error / Math.Min(_count, 2);
                }
            }
            MeanSquare = sum / _count;
            if (stiffness > 0) _step = pull > stiffness ? 1 : pull < -stiffness ? -1 : pull / stiffness;
            return true;
        }
    }
}
