using System;
using Nowpose.Messages;

namespace Nowpose.Prediction.Planning
{
    /// <summary>
    /// The planned path of one joint: set-points, interpolated as in ROS's joint_trajectory_controller.
    /// </summary>
    /// <remarks>
    /// Interpolates linearly between positions; with cubics if the velocities are known; with quintics if the accelerations are also known. Immutable
    /// and thread-safe.
    /// </remarks>
    sealed class JointPath
    {
        readonly double[] _times;
        readonly double[] _positions;
        readonly double[] _velocities;
        readonly double[] _accelerations;

        /// <param name="times">Seconds after the plan's stamp, 0 or more, each later than the previous one; at least one.</param>
        /// <param name="positions">rad or m, one for each time, finite.</param>
        /// <param name="velocities">rad/s or m/s, one for each time, NaN if unknown; null if all are unknown.</param>
        /// <param name="accelerations">rad/s² or m/s², one for each time, NaN if unknown; null if all are unknown.</param>
        /// <exception cref="ArgumentException">The lengths differ, or the times do not increase.</exception>
        public JointPath(double[] times, double[] positions, double[] velocities = null, double[] accelerations = null)
        {
            if (times.Length == 0 || positions.Length != times.Length)
                throw new ArgumentException(PredictionMessages.PositionCount(positions.Length, times.Length));
            if ((velocities ?? times).Length != times.Length || (accelerations ?? times).Length != times.Length)
                throw new ArgumentException(PredictionMessages.DerivativeCount(times.Length));
            for (var i = 1; i < times.Length; i++)
                if (!(times[i] > times[i - 1]))
                    throw new ArgumentException(PredictionMessages.TimeOrder(i, times[i], times[i - 1]));

            _times = times;
            _positions = positions;
            _velocities = velocities;
            _accelerations = accelerations;
            var (min, max) = (positions[0], positions[0]);
            foreach (var position in positions) (min, max) = (Math.Min(min, position), Math.Max(max, position));
            Range = max - min;
        }

        /// <summary>Time of the first set-point, in s after the stamp.</summary>
        public double First => _times[0];

        /// <summary>Time of the last set-point, in s after the stamp.</summary>
        public double Last => _times[_times.Length - 1];

        public double FirstPosition => _positions[0];

        /// <summary>Difference between the maximum and the minimum set-point, in rad or m.</summary>
        public double Range { get; }

        /// <summary>Whether the joint is at rest at the end of the path.</summary>
        public bool EndsAtRest => !(Math.Abs(Value(_velocities, _times.Length - 1)) > 0);

        /// <summary>Returns the position at a given time. Before the first set-point and after the last, it is constant.</summary>
        /// <param name="time">Time in s after the stamp.</param>
        public double At(double time, out double velocity)
        {
            velocity = 0;
            if (time <= First) return _positions[0];
            if (time >= Last) return _positions[_positions.Length - 1];
            var i = SegmentOf(time);
            var length = _times[i + 1] - _times[i];
            var x = (time - _times[i]) / length;
            var displacement = _positions[i + 1] - _positions[i];
            var (v0, v1) = (Value(_velocities, i) * length, Value(_velocities, i + 1) * length);
            var (a0, a1) = (Value(_accelerations, i) * length * length, Value(_accelerations, i + 1) * length * length);
            // c0 is the position. The other coefficients follow from the known values at both ends. x runs from 0 to 1.
            double c1 = displacement, c2 = 0, c3 = 0, c4 = 0, c5 = 0;
            if (!double.IsNaN(v0 + v1 + a0 + a1))
                (c1, c2, c3, c4, c5) = (
                    v0, a0 / 2, 10 * displacement - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1,
                    -15 * displacement + 8 * v0 + 7 * v1 + 1.5 * a0 - a1, 6 * displacement - 3 * (v0 + v1) + 0.5 * (a1 - a0));
            else if (!double.IsNaN(v0 + v1))
                (c1, c2, c3) = (v0, 3 * displacement - 2 * v0 - v1, v0 + v1 - 2 * displacement);
            velocity = (c1 + x * (2 * c2 + x * (3 * c3 + x * (4 * c4 + x * 5 * c5)))) / length;
            return _positions[i] + x * (c1 + x * (c2 + x * (c3 + x * (c4 + x * c5))));
        }

        int SegmentOf(double time)
        {
            var (low, high) = (0, _times.Length - 1);
            while (high - low > 1)
            {
                var middle = (low + high) / 2;
                if (_times[middle] <= time) low = middle;
                else high = middle;
            }
            return low;
        }

        static double Value(double[] values, int i) => values == null ? double.NaN : values[i];
    }
}
