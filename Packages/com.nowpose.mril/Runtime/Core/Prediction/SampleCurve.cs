using System;

namespace Nowpose.Prediction
{
    /// <summary>A smooth curve through samples at any intervals: exact for quadratics, without overshoot where the samples are monotone.</summary>
    /// <remarks>
    /// A cubic Hermite whose slopes are those of the parabolas through neighbours, with the
    /// limit of Fritsch &amp; Carlson (1980). The limit acts only where samples rise or fall throughout: at a turning point it
    /// would flatten what lies between the samples. Allocates nothing once made.
    /// </remarks>
    sealed class SampleCurve
    {
        /// <summary>A cubic whose end slopes are within three times the secant's is monotone: Fritsch &amp; Carlson.</summary>
        const double GreatestSlope = 3;

        readonly double[] _times;
        readonly double[] _positions;
        readonly double[] _secants;
        readonly double[] _slopes;

        public SampleCurve(int capacity)
        {
            _times = new double[capacity];
            _positions = new double[capacity];
            _secants = new double[capacity];
            _slopes = new double[capacity];
        }

        public int Count { get; private set; }

        /// <summary>s; meaningful with at least one point.</summary>
        public double Start => _times[0];

        /// <summary>s; meaningful with at least one point.</summary>
        public double End => _times[Count - 1];

        public void Clear() => Count = 0;

        /// <summary>Takes the next point; one that is not later than the last is left out.</summary>
        public void Append(double time, double position)
        {
            if (Count > 0 && !(time > _times[Count - 1])) return;
            _times[Count] = time;
            _positions[Count++] = position;
        }

        /// <summary>Computes the slopes once all points are there.</summary>
        public void Complete()
        {
            for (var i = 0; i + 1 < Count; i++) _secants[i] = (_positions[i + 1] - _positions[i]) / (_times[i + 1] - _times[i]);
            for (var i = 0; i < Count; i++) _slopes[i] = Count < 3 ? _secants[0] : Limited(i, Parabola(i));
        }

        /// <param name="time">Between <see cref="Start"/> and <see cref="End"/>, of two points at least.</param>
        public double At(double time)
        {
            var i = 0;
            while (i < Count - 2 && time > _times[i + 1]) i++;
            var length = _times[i + 1] - _times[i];
            var x = (time - _times[i]) / length;
            var (before, after) = ((_slopes[i] - _secants[i]) * length, (_secants[i] - _slopes[i + 1]) * length);
            // The straight line, and what the slopes at both ends add to it.
            return _positions[i] + x * (_positions[i + 1] - _positions[i]) + x * (1 - x) * (before * (1 - x) + after * x);
        }

        // Slope at a point of the parabola through it and its neighbours; at an end, of the last three points.
        double Parabola(int i)
        {
            var middle = Math.Min(Math.Max(i, 1), Count - 2);
            var (left, right) = (_times[middle] - _times[middle - 1], _times[middle + 1] - _times[middle]);
            var bend = (_secants[middle] - _secants[middle - 1]) / (left + right);
            var atMiddle = _secants[middle - 1] + bend * left;
            return atMiddle + 2 * bend * (_times[i] - _times[middle]);
        }

        double Limited(int i, double slope)
        {
            if (i > 0 && IsMonotone(i - 1)) slope = Within(_secants[i - 1], slope);
            if (i < Count - 1 && IsMonotone(i)) slope = Within(_secants[i], slope);
            return slope;
        }

        // Around an interval nothing goes the other way.
        bool IsMonotone(int interval)
        {
            var (up, down) = (false, false);
            for (var i = Math.Max(interval - 1, 0); i <= Math.Min(interval + 1, Count - 2); i++)
            {
                up |= _secants[i] > 0;
                down |= _secants[i] < 0;
            }
            return !(up && down);
        }

        static double Within(double secant, double slope)
        {
            var bound = GreatestSlope * secant;
            return bound >= 0 ? Math.Min(Math.Max(slope, 0), bound) : Math.Max(Math.Min(slope, 0), bound);
        }
    }
}
