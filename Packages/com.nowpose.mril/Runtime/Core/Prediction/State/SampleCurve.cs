using System;

namespace Nowpose.Prediction.State
{
    /// <summary>
    /// A smooth curve through the samples of a motion: exact for quadratics, without overshoot if the samples are monotone.
    /// </summary>
    /// <remarks>
    /// A cubic Hermite spline whose slopes come from the parabolas through neighbouring samples, with the limit of Fritsch &amp; Carlson (1980). The
    /// limit applies only where samples rise or fall monotonically: at a turning point it would flatten the curve between the samples. Stores no
    /// results: each call uses the samples around the requested time.
    /// </remarks>
    readonly struct SampleCurve
    {
        /// <summary>A cubic with end slopes within three times the secant's is monotone (Fritsch &amp; Carlson).</summary>
        const double MaxSlope = 3;

        readonly double[] _times, _displacements;
        readonly int _component, _components, _count;

        /// <param name="motion">Has at least two samples.</param>
        public SampleCurve(MotionState motion, int component)
        {
            (_times, _displacements, _count) = (motion.Times, motion.Displacements, motion.Count);
            (_component, _components) = (component, motion.Components);
        }

        /// <summary>Returns the position relative to that of the newest sample.</summary>
        /// <param name="ahead">Time between the oldest and the newest sample, relative to the newest, in s; not positive.</param>
        public double At(double ahead)
        {
            // Finds the interval between the samples of this age and the next older one.
            var age = 0;
            while (age < _count - 2 && ahead <= _times[age + 1]) age++;
            var length = _times[age] - _times[age + 1];
            // The oldest sample of another motion of the same object may be earlier.
            var x = Math.Max(ahead - _times[age + 1], 0) / length;
            var secant = Secant(age);
            var (before, after) = ((Slope(age + 1) - secant) * length, (secant - Slope(age)) * length);
            // The straight line plus the contribution of the slopes at both ends.
            return Position(age + 1) + x * (Position(age) - Position(age + 1)) + x * (1 - x) * (before * (1 - x) + after * x);
        }

        double Position(int age) => _displacements[age * _components + _component];

        // Slope from the sample of this age to the next older one.
        double Secant(int age) => (Position(age) - Position(age + 1)) / (_times[age] - _times[age + 1]);

        double Slope(int age)
        {
            if (_count < 3) return Secant(0);
            var slope = Parabola(age);
            if (age < _count - 1 && IsMonotone(age)) slope = Within(Secant(age), slope);
            if (age > 0 && IsMonotone(age - 1)) slope = Within(Secant(age - 1), slope);
            return slope;
        }

        // Slope, at a sample, of the parabola through the sample and its two neighbours. The first and the last sample use the three samples at their
        // end.
        double Parabola(int age)
        {
            var middle = Math.Min(Math.Max(age, 1), _count - 2);
            var (older, newer) = (Secant(middle), Secant(middle - 1));
            var bend = (newer - older) / (_times[middle - 1] - _times[middle + 1]);
            return older + bend * (_times[middle] - _times[middle + 1]) + 2 * bend * (_times[age] - _times[middle]);
        }

        // Returns whether this interval and its neighbours have the same direction.
        bool IsMonotone(int interval)
        {
            var (up, down) = (false, false);
            for (var i = Math.Max(interval - 1, 0); i <= Math.Min(interval + 1, _count - 2); i++)
            {
                var secant = Secant(i);
                up |= secant > 0;
                down |= secant < 0;
            }
            return !(up && down);
        }

        static double Within(double secant, double slope)
        {
            var bound = MaxSlope * secant;
            return bound >= 0 ? Math.Min(Math.Max(slope, 0), bound) : Math.Max(Math.Min(slope, 0), bound);
        }
    }
}
