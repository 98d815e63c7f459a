using System;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Fitting
{
    /// <summary>Mean of poses without outliers.</summary>
    /// <remarks>
    /// A pose whose distance or angle from the centre exceeds a multiple of the median is omitted entirely. Position and rotation of the
    /// other poses are averaged.
    /// </remarks>
    readonly struct PoseMean
    {
        /// <summary>
        /// Outlier threshold as a multiple of the median distance. For normally distributed noise in three directions, it corresponds to 3.8 standard
        /// deviations in one direction; 0.2 % of the poses exceed it.
        /// </summary>
        const double Reach = 2.5;

        /// <summary>Minimum thresholds, which cover the rounding errors of equal poses.</summary>
        const double MinMetres = 1e-6, MinRadians = 1e-6;

        const int Rounds = 4;

        /// <summary>
        /// Maximum difference between the means of the two halves, in standard errors of this difference. Noise alone exceeds it once in
        /// 100 000 cases.
        /// </summary>
        const double MaxStandardErrors = 3;

        readonly double _shiftMetres, _shiftRadians;

        PoseMean(
            in RigidTransform pose, int inliers, double share, double shareOfBetterHalf, double spreadMetres, double spreadRadians,
            double shiftMetres, double shiftRadians)
        {
            _shiftMetres = shiftMetres;
            _shiftRadians = shiftRadians;
            Pose = pose;
            Inliers = inliers;
            InlierShare = share;
            InlierShareOfBetterHalf = shareOfBetterHalf;
            SpreadMetres = spreadMetres;
            SpreadRadians = spreadRadians;
        }

        public RigidTransform Pose { get; }
        public int Inliers { get; }

        /// <summary>Fraction of the poses that are not outliers.</summary>
        public double InlierShare { get; }

        /// <summary>
        /// The larger of the inlier fractions of the older and of the newer half. After one step of the poses, one half contains most outliers.
        /// </summary>
        public double InlierShareOfBetterHalf { get; }

        /// <summary>Root mean square of the distances from the mean, m.</summary>
        public double SpreadMetres { get; }

        /// <summary>Root mean square of the angles to the mean, rad.</summary>
        public double SpreadRadians { get; }

        /// <summary>Estimated root-mean-square error of the mean's position, m, assuming that the errors of the poses are independent.</summary>
        public double ErrorMetres => SpreadMetres / Math.Sqrt(Inliers);

        /// <summary>Estimated error of the mean's rotation, rad.</summary>
        public double ErrorRadians => SpreadRadians / Math.Sqrt(Inliers);

        /// <summary>
        /// Returns whether the means of the older and the newer half of the poses agree. The mean of a moving marker is meaningless.
        /// </summary>
        /// <param name="metres">Position difference that is always allowed, even if the scatter is small, m.</param>
        /// <param name="radians">Angle difference that is always allowed, rad.</param>
        public bool IsSteady(double metres, double radians) =>
            _shiftMetres <= Math.Max(metres, 2 * MaxStandardErrors * ErrorMetres)
            && _shiftRadians <= Math.Max(radians, 2 * MaxStandardErrors * ErrorRadians);

        /// <param name="count">Number of newest poses to use; one or more.</param>
        public static PoseMean Of(PoseWindow window, int count, PoseMeanSpace space)
        {
            var (distances, angles, weights) = (space.Distances, space.Angles, space.Weights);
            var middle = MedianPosition(window, count, space);
            for (var i = 0; i < count; i++)
            {
                distances[i] = DistanceOf(window.PoseOf(i), middle);
                weights[i] = 1;
            }
            var reach = Math.Max(Reach * space.MedianOf(distances, count), MinMetres);
            for (var i = 0; i < count; i++)
                if (distances[i] > reach) weights[i] = 0;

            // Computes an approximate median of the rotations, in which outliers have little influence, and then the mean of the rotations near it.
            var mean = Mean(window, count, weights);
            for (var round = 0; round < Rounds; round++)
            {
                for (var i = 0; i < count; i++) angles[i] = window.PoseOf(i).AngleTo(mean);
                var typical = space.MedianOf(angles, count);
                for (var i = 0; i < count; i++)
                {
                    if (distances[i] > reach) weights[i] = 0;
                    else if (round < Rounds / 2) weights[i] = 1 / (angles[i] + 0.1 * typical + MinRadians);
                    else weights[i] = angles[i] <= Math.Max(Reach * typical, MinRadians) ? 1 : 0;
                }
                mean = Mean(window, count, weights);
            }
            return Measured(window, count, weights, mean);
        }

        static PoseMean Measured(PoseWindow window, int count, double[] weights, in RigidTransform mean)
        {
            var (inliers, newer) = (0, 0);
            double metres = 0, radians = 0;
            for (var i = 0; i < count; i++)
            {
                if (weights[i] == 0) continue;
                inliers++;
                if (i < count / 2) newer++;
                double distance = window.PoseOf(i).DistanceTo(mean), angle = window.PoseOf(i).AngleTo(mean);
                metres += distance * distance;
                radians += angle * angle;
            }
            // The mean was computed from the same poses, so the scatter has one degree of freedom fewer in each direction.
            var free = Math.Max(inliers - 1, 1);
            var (shiftMetres, shiftRadians) = Shift(window, count, weights, mean, inliers);
            var better = Math.Max((double)newer / Math.Max(count / 2, 1), (double)(inliers - newer) / (count - count / 2));
            return new PoseMean(
                mean, inliers, (double)inliers / count, better, Math.Sqrt(metres / free), Math.Sqrt(radians / free), shiftMetres, shiftRadians);
        }

        /// <summary>Returns the difference between the means of the newer and the older half.</summary>
        static (double Metres, double Radians) Shift(PoseWindow window, int count, double[] weights, in RigidTransform mean, int inliers)
        {
            int newer = inliers / 2, older = inliers - newer, passed = 0;
            double x = 0, y = 0, z = 0, turnX = 0, turnY = 0, turnZ = 0;
            var back = mean.Inverse;
            for (var i = 0; i < count; i++)
            {
                if (weights[i] == 0) continue;
                var share = passed++ < newer ? 1.0 / newer : -1.0 / older;
                var apart = back * window.PoseOf(i);
                var turn = apart.RotationVector();
                (x, y, z) = (x + share * apart.X, y + share * apart.Y, z + share * apart.Z);
                (turnX, turnY, turnZ) = (turnX + share * turn.X, turnY + share * turn.Y, turnZ + share * turn.Z);
            }
            return (PoseNumbers.Length(x, y, z), PoseNumbers.Length(turnX, turnY, turnZ));
        }

        static RigidTransform Mean(PoseWindow window, int count, double[] weights)
        {
            var fit = new RotationFit();
            double x = 0, y = 0, z = 0, sum = 0;
            for (var i = 0; i < count; i++)
            {
                if (weights[i] == 0) continue;
                ref readonly var pose = ref window.PoseOf(i);
                fit.Add(pose, weights[i]);
                x += weights[i] * pose.X;
                y += weights[i] * pose.Y;
                z += weights[i] * pose.Z;
                sum += weights[i];
            }
            return fit.Solve().MovedTo(x / sum, y / sum, z / sum);
        }

        static (double X, double Y, double Z) MedianPosition(PoseWindow window, int count, PoseMeanSpace space)
        {
            var values = space.Distances;
            for (var i = 0; i < count; i++) values[i] = window.PoseOf(i).X;
            var x = space.MedianOf(values, count);
            for (var i = 0; i < count; i++) values[i] = window.PoseOf(i).Y;
            var y = space.MedianOf(values, count);
            for (var i = 0; i < count; i++) values[i] = window.PoseOf(i).Z;
            return (x, y, space.MedianOf(values, count));
        }

        static double DistanceOf(in RigidTransform pose, (double X, double Y, double Z) to) =>
            PoseNumbers.Length(pose.X - to.X, pose.Y - to.Y, pose.Z - to.Z);
    }

    /// <summary>Reusable buffers for the computation of a <see cref="PoseMean"/>.</summary>
    sealed class PoseMeanSpace
    {
        readonly double[] _sorted = new double[PoseWindow.Capacity];

        public double[] Distances { get; } = new double[PoseWindow.Capacity];
        public double[] Angles { get; } = new double[PoseWindow.Capacity];
        public double[] Weights { get; } = new double[PoseWindow.Capacity];

        /// <param name="count">One or more.</param>
        public double MedianOf(double[] values, int count)
        {
            Array.Copy(values, _sorted, count);
            return SortToMedian(_sorted, count);
        }

        /// <summary>Sorts the first values and returns their median.</summary>
        /// <param name="count">One or more.</param>
        public static double SortToMedian(double[] values, int count)
        {
            Array.Sort(values, 0, count);
            return (values[(count - 1) / 2] + values[count / 2]) / 2;
        }
    }
}
