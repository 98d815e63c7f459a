using System;
using System.Runtime.CompilerServices;

namespace Nowpose.Kinematics
{
    /// <summary>A rotation followed by a translation in metres: the pose of one right-handed frame in another.</summary>
    /// <remarks>
    /// <c>parent * child</c> is the child's pose in the reference frame of the parent's pose. It has 96 bytes, so pass it by <c>in</c>.
    /// <c>default</c> is not a valid pose (its rotation is zero); start from <see cref="Identity"/>.
    /// </remarks>
    public readonly struct RigidTransform
    {
        // Rotation in row-major order; the columns are the child's axes in the parent's frame.
        internal readonly double R00, R01, R02, R10, R11, R12, R20, R21, R22;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        internal RigidTransform(
            double r00, double r01, double r02, double r10, double r11, double r12, double r20, double r21, double r22,
            double x, double y, double z)
        {
            R00 = r00; R01 = r01; R02 = r02;
            R10 = r10; R11 = r11; R12 = r12;
            R20 = r20; R21 = r21; R22 = r22;
            X = x; Y = y; Z = z;
        }

        public static RigidTransform Identity { get; } = new RigidTransform(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0);

        /// <summary>Translation along the parent's x axis, metres.</summary>
        public double X { get; }

        /// <summary>Translation along the parent's y axis, metres.</summary>
        public double Y { get; }

        /// <summary>Translation along the parent's z axis, metres.</summary>
        public double Z { get; }

        /// <summary>Creates a pose from a URDF origin: metres, and radians about the parent's fixed x, then y, then z axis.</summary>
        public static RigidTransform FromXyzRpy(double x, double y, double z, double roll, double pitch, double yaw)
        {
            double sr = Math.Sin(roll), cr = Math.Cos(roll);
            double sp = Math.Sin(pitch), cp = Math.Cos(pitch);
            double sy = Math.Sin(yaw), cy = Math.Cos(yaw);
            return new RigidTransform(
                cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,
                sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,
                -sp, cp * sr, cp * cr,
                x, y, z);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static RigidTransform operator *(in RigidTransform a, in RigidTransform b) => new RigidTransform(
            a.R00 * b.R00 + a.R01 * b.R10 + a.R02 * b.R20,
            a.R00 * b.R01 + a.R01 * b.R11 + a.R02 * b.R21,
            a.R00 * b.R02 + a.R01 * b.R12 + a.R02 * b.R22,
            a.R10 * b.R00 + a.R11 * b.R10 + a.R12 * b.R20,
            a.R10 * b.R01 + a.R11 * b.R11 + a.R12 * b.R21,
            a.R10 * b.R02 + a.R11 * b.R12 + a.R12 * b.R22,
            a.R20 * b.R00 + a.R21 * b.R10 + a.R22 * b.R20,
            a.R20 * b.R01 + a.R21 * b.R11 + a.R22 * b.R21,
            a.R20 * b.R02 + a.R21 * b.R12 + a.R22 * b.R22,
            a.R00 * b.X + a.R01 * b.Y + a.R02 * b.Z + a.X,
            a.R10 * b.X + a.R11 * b.Y + a.R12 * b.Z + a.Y,
            a.R20 * b.X + a.R21 * b.Y + a.R22 * b.Z + a.Z);

        /// <summary>The parent's pose in the child's frame: <c>pose * pose.Inverse</c> is <see cref="Identity"/>.</summary>
        public RigidTransform Inverse => new RigidTransform(
            R00, R10, R20, R01, R11, R21, R02, R12, R22,
            -(R00 * X + R10 * Y + R20 * Z), -(R01 * X + R11 * Y + R21 * Z), -(R02 * X + R12 * Y + R22 * Z));

        /// <summary>Returns the 4×4 matrix for column vectors, row by row: the translation is in elements 3, 7 and 11.</summary>
        public double[] ToRowMajor16() => new[]
        {
            R00, R01, R02, X,
            R10, R11, R12, Y,
            R20, R21, R22, Z,
            0, 0, 0, 1,
        };

        public override string ToString() => FormattableString.Invariant($"({X:0.######}, {Y:0.######}, {Z:0.######}) m");
    }
}
