using System;
using System.Runtime.CompilerServices;

namespace Nowpose.Kinematics
{
    /// <summary>A rotation as a quaternion of length one: x, y, z are the vector part, w is the scalar part.</summary>
    /// <remarks>
    /// <c>a * b</c> applies b first, as with matrices. q and −q are the same rotation. <c>default</c> is not a rotation (its length is zero);
    /// start from <see cref="Identity"/>.
    /// </remarks>
    readonly struct UnitQuaternion
    {
        /// <summary>
        /// Maximum difference between the length of an input quaternion and one. It allows, for example, components with three decimals.
        /// </summary>
        public const double LengthTolerance = 1e-3;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        UnitQuaternion(double x, double y, double z, double w)
        {
            X = x;
            Y = y;
            Z = z;
            W = w;
        }

        public static UnitQuaternion Identity { get; } = new UnitQuaternion(0, 0, 0, 1);

        public double X { get; }

        public double Y { get; }

        public double Z { get; }

        public double W { get; }

        /// <summary>Whether the value is a rotation; false only for <c>default</c>.</summary>
        public bool IsRotation => X != 0 || Y != 0 || Z != 0 || W != 0;

        /// <summary>Creates a rotation from four components whose length is 1 within <see cref="LengthTolerance"/>, and normalises them.</summary>
        /// <returns>False if the components have another length or are not finite.</returns>
        public static bool TryNormalise(double x, double y, double z, double w, out UnitQuaternion rotation)
        {
            var length = LengthOf(x, y, z, w);
            var isUnit = Math.Abs(length - 1) <= LengthTolerance;
            rotation = isUnit ? new UnitQuaternion(x / length, y / length, z / length, w / length) : Identity;
            return isUnit;
        }

        /// <summary>Returns the rotation of a pose.</summary>
        public static UnitQuaternion Of(in RigidTransform pose)
        {
            // Divides by the largest of 4w², 4x², 4y² and 4z², so that rounding errors stay small.
            double w = 1 + pose.R00 + pose.R11 + pose.R22, x = 1 + pose.R00 - pose.R11 - pose.R22;
            double y = 1 - pose.R00 + pose.R11 - pose.R22, z = 1 - pose.R00 - pose.R11 + pose.R22;
            if (w >= x && w >= y && w >= z) return Normalised(pose.R21 - pose.R12, pose.R02 - pose.R20, pose.R10 - pose.R01, w);
            if (x >= y && x >= z) return Normalised(x, pose.R10 + pose.R01, pose.R02 + pose.R20, pose.R21 - pose.R12);
            return y >= z
                ? Normalised(pose.R10 + pose.R01, y, pose.R21 + pose.R12, pose.R02 - pose.R20)
                : Normalised(pose.R02 + pose.R20, pose.R21 + pose.R12, z, pose.R10 - pose.R01);
        }

        /// <summary>Returns the length of a quaternion that need not be a rotation.</summary>
        public static double LengthOf(double x, double y, double z, double w) => Math.Sqrt(x * x + y * y + z * z + w * w);

        /// <summary>Returns the rotation about the direction of a vector, by an angle in rad that equals the length of the vector.</summary>
        public static UnitQuaternion Exp(in Vector3D vector)
        {
            var angle = vector.Length;
            // Computes sin(a / 2) / a. Below 1e-3 rad, the error of the series is less than the rounding error.
            var scale = angle < 1e-3 ? 0.5 - angle * angle / 48 : Math.Sin(0.5 * angle) / angle;
            return Normalised(scale * vector.X, scale * vector.Y, scale * vector.Z, Math.Cos(0.5 * angle));
        }

        /// <summary>Returns the shortest rotation vector, 0 to π rad long, the same for q and −q.</summary>
        public Vector3D Log()
        {
            var sine = Math.Sqrt(X * X + Y * Y + Z * Z);
            var (s, c) = W < 0 ? (-1.0, -W) : (1.0, W);
            // angle / sin(angle / 2), with the sign of the shortest rotation.
            var scale = s * (sine < 1e-9 ? 2 / c : 2 * Math.Atan2(sine, c) / sine);
            return new Vector3D(scale * X, scale * Y, scale * Z);
        }

        public UnitQuaternion Inverse
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get => new UnitQuaternion(-X, -Y, -Z, W);
        }

        /// <summary>
        /// Rotation about z that remains when the z axis is turned back to its original direction on the shortest way; the identity if the z axis
        /// points in the opposite direction.
        /// </summary>
        public UnitQuaternion AboutZ => Z * Z + W * W < 1e-12 ? Identity : Normalised(0, 0, Z, W);

        // In this order, the rounding errors cancel if b is the inverse of a.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static UnitQuaternion operator *(in UnitQuaternion a, in UnitQuaternion b) => Normalised(
            a.W * b.X + a.X * b.W + a.Y * b.Z - a.Z * b.Y,
            a.W * b.Y + a.Y * b.W + a.Z * b.X - a.X * b.Z,
            a.W * b.Z + a.Z * b.W + a.X * b.Y - a.Y * b.X,
            a.W * b.W - a.X * b.X - a.Y * b.Y - a.Z * b.Z);

        /// <summary>Interpolates at a constant rate along the shorter arc (spherical linear interpolation).</summary>
        /// <param name="fraction">0 for the first rotation, 1 for the second; other values extrapolate.</param>
        public static UnitQuaternion Slerp(in UnitQuaternion from, in UnitQuaternion to, double fraction) =>
            from * Exp((from.Inverse * to).Log() * fraction);

        /// <summary>Returns the angle between two rotations, 0 to π rad.</summary>
        public static double AngleBetween(in UnitQuaternion a, in UnitQuaternion b) => (a.Inverse * b).Log().Length;

        /// <summary>Returns the pose with this rotation and a translation in m.</summary>
        public RigidTransform At(double x, double y, double z)
        {
            double xx = 2 * X * X, yy = 2 * Y * Y, zz = 2 * Z * Z;
            double xy = 2 * X * Y, xz = 2 * X * Z, yz = 2 * Y * Z, wx = 2 * W * X, wy = 2 * W * Y, wz = 2 * W * Z;
            return new RigidTransform(
                1 - yy - zz, xy - wz, xz + wy,
                xy + wz, 1 - xx - zz, yz - wx,
                xz - wy, yz + wx, 1 - xx - yy,
                x, y, z);
        }

        public override string ToString() => FormattableString.Invariant($"({X:0.######}, {Y:0.######}, {Z:0.######}, {W:0.######})");

        /// <summary>Returns the rotation of a quaternion of any length except zero.</summary>
        /// <remarks>Each product is normalised, because its rounding errors would otherwise accumulate.</remarks>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static UnitQuaternion Normalised(double x, double y, double z, double w)
        {
            var scale = 1 / LengthOf(x, y, z, w);
            return new UnitQuaternion(scale * x, scale * y, scale * z, scale * w);
        }
    }
}
