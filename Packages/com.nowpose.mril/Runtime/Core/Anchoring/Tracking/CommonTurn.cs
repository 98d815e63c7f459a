using System;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>Mean turn of markers since the lock, with its uncertainty.</summary>
    readonly struct CommonTurn
    {
        readonly Vector3D _sum;
        readonly double _variance;
        readonly int _count;

        /// <param name="sum">Sum of the rotation vectors of the markers, in the room frame, rad.</param>
        /// <param name="variance">Sum of their variances about an axis, rad².</param>
        /// <param name="count">Number of markers.</param>
        public CommonTurn(in Vector3D sum, double variance, int count) => (_sum, _variance, _count) = (sum, variance, count);

        /// <summary>Angle of the mean turn; 0 without any marker.</summary>
        public double Radians => _sum.Length / Math.Max(_count, 1);

        double Sd => Math.Sqrt(_variance) / Math.Max(_count, 1);

        public CommonTurn And(in CommonTurn other) => new CommonTurn(_sum + other._sum, _variance + other._variance, _count + other._count);

        /// <summary>Returns whether the angle exceeds the limit by more than its own uncertainty.</summary>
        public bool IsBeyond(double radians) => Radians > radians + DeviationWatch.MinStandardErrors * Sd;

        /// <summary>Returns whether the angle is clearly within the limit.</summary>
        public bool IsWithin(double radians) => Radians < DeviationWatch.WithinRatio * radians;
    }
}
