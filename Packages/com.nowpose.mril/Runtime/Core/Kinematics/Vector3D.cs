using System;

namespace Nowpose.Kinematics
{
    /// <summary>
    /// Three components along x, y and z: a position in m, a rotation vector (along the axis, with the angle in rad as its length), or a sum
    /// of rotation vectors.
    /// </summary>
    readonly struct Vector3D
    {
        public Vector3D(double x, double y, double z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        public double X { get; }

        public double Y { get; }

        public double Z { get; }

        public double Length => Math.Sqrt(X * X + Y * Y + Z * Z);

        /// <param name="component">0 for x, 1 for y, 2 for z.</param>
        public double this[int component] => component == 0 ? X : component == 1 ? Y : Z;

        public static Vector3D operator +(in Vector3D a, in Vector3D b) => new Vector3D(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        public static Vector3D operator -(in Vector3D a, in Vector3D b) => new Vector3D(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

        public static Vector3D operator *(in Vector3D a, double factor) => new Vector3D(factor * a.X, factor * a.Y, factor * a.Z);
    }
}
