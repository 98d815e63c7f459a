using System;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring
{
    /// <summary>Computations with poses, such as distances and interpolation.</summary>
    static class PoseNumbers
    {
        /// <summary>Tolerance for the length of a rotation's rows, which should be 1. The rounding errors of floats are smaller.</summary>
        const double Unit = 1e-3;

        /// <summary>Returns whether all numbers are finite and the rotation is valid.</summary>
        public static bool IsPose(this in RigidTransform pose)
        {
            var r = pose;
            return double.IsFinite(r.X + r.Y + r.Z)
                && IsUnit(r.R00, r.R01, r.R02) && IsUnit(r.R10, r.R11, r.R12) && IsUnit(r.R20, r.R21, r.R22)
                && Determinant(r) > 0;
        }

        /// <summary>Returns the distance between the origins, in metres.</summary>
        public static double DistanceTo(this in RigidTransform a, in RigidTransform b) => Length(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

        /// <summary>Returns the angle between the rotations, 0 to π rad.</summary>
        public static double AngleTo(this in RigidTransform a, in RigidTransform b)
        {
            // Uses the sine from the antisymmetric part of aᵀb, because the cosine alone is inaccurate for angles below 1e-8.
            var (x, y, z) = TwiceSine(a, b);
            return Math.Atan2(Length(x, y, z) / 2, (Trace(a, b) - 1) / 2);
        }

        /// <summary>Returns the rotation vector: its direction is the axis, and its length is the angle, up to π rad.</summary>
        public static (double X, double Y, double Z) RotationVector(this in RigidTransform pose)
        {
            var (x, y, z) = TwiceSine(RigidTransform.Identity, pose);
            var sine = Length(x, y, z) / 2;
            var angle = Math.Atan2(sine, (pose.R00 + pose.R11 + pose.R22 - 1) / 2);
            if (sine < 1e-9) return pose.R00 + pose.R11 + pose.R22 > 1 ? (0, 0, 0) : HalfTurn(pose);
            var scale = angle / (2 * sine);
            return (x * scale, y * scale, z * scale);
        }

        // The sine is zero at half a turn. The axis a follows from the rotation matrix R: R + I = 2aaᵀ.
        static (double X, double Y, double Z) HalfTurn(in RigidTransform r)
        {
            var (x, y, z) = r.R00 >= r.R11 && r.R00 >= r.R22 ? (r.R00 + 1, r.R10, r.R20)
                : r.R11 >= r.R22 ? (r.R01, r.R11 + 1, r.R21) : (r.R02, r.R12, r.R22 + 1);
            var scale = Math.PI / Length(x, y, z);
            return (scale * x, scale * y, scale * z);
        }

        /// <summary>Returns the rotation that a rotation vector in rad describes.</summary>
        public static RigidTransform Turn(double x, double y, double z)
        {
            var angle = Length(x, y, z);
            if (angle == 0) return RigidTransform.Identity;
            (x, y, z) = (x / angle, y / angle, z / angle);
            double c = Math.Cos(angle), s = Math.Sin(angle), t = 1 - c;
            return new RigidTransform(
                t * x * x + c, t * x * y - s * z, t * x * z + s * y,
                t * x * y + s * z, t * y * y + c, t * y * z - s * x,
                t * x * z - s * y, t * y * z + s * x, t * z * z + c,
                0, 0, 0);
        }

        /// <summary>Interpolates between two poses: linearly in position, at a constant rate in rotation.</summary>
        /// <param name="part">Fraction of the way from <paramref name="from"/> to <paramref name="to"/>, 0 to 1.</param>
        public static RigidTransform Between(in RigidTransform from, in RigidTransform to, double part)
        {
            var (x, y, z) = (from.Inverse * to).RotationVector();
            return (from * Turn(x * part, y * part, z * part)).MovedTo(
                from.X + (to.X - from.X) * part, from.Y + (to.Y - from.Y) * part, from.Z + (to.Z - from.Z) * part);
        }

        /// <summary>Returns the same rotation with another translation.</summary>
        public static RigidTransform MovedTo(this in RigidTransform pose, double x, double y, double z) => new RigidTransform(
            pose.R00, pose.R01, pose.R02, pose.R10, pose.R11, pose.R12, pose.R20, pose.R21, pose.R22, x, y, z);

        public static double Length(double x, double y, double z) => Math.Sqrt(x * x + y * y + z * z);

        static (double X, double Y, double Z) TwiceSine(in RigidTransform a, in RigidTransform b) => (
            Dot(a.R02, a.R12, a.R22, b.R01, b.R11, b.R21) - Dot(a.R01, a.R11, a.R21, b.R02, b.R12, b.R22),
            Dot(a.R00, a.R10, a.R20, b.R02, b.R12, b.R22) - Dot(a.R02, a.R12, a.R22, b.R00, b.R10, b.R20),
            Dot(a.R01, a.R11, a.R21, b.R00, b.R10, b.R20) - Dot(a.R00, a.R10, a.R20, b.R01, b.R11, b.R21));

        static double Trace(in RigidTransform a, in RigidTransform b) =>
            Dot(a.R00, a.R10, a.R20, b.R00, b.R10, b.R20) + Dot(a.R01, a.R11, a.R21, b.R01, b.R11, b.R21)
            + Dot(a.R02, a.R12, a.R22, b.R02, b.R12, b.R22);

        static double Determinant(in RigidTransform r) =>
            r.R00 * (r.R11 * r.R22 - r.R12 * r.R21) - r.R01 * (r.R10 * r.R22 - r.R12 * r.R20) + r.R02 * (r.R10 * r.R21 - r.R11 * r.R20);

        static bool IsUnit(double x, double y, double z) => Math.Abs(Length(x, y, z) - 1) < Unit;

        static double Dot(double ax, double ay, double az, double bx, double by, double bz) => ax * bx + ay * by + az * bz;
    }
}
