using System;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring
{
    /// <summary>Measures of poses, and of how far apart two are.</summary>
    static class PoseNumbers
    {
        /// <summary>How far a row of a rotation may be from unit length: floats are off by less.</summary>
        const double Unit = 1e-3;

        /// <summary>Whether all numbers are finite and the rotation is one.</summary>
        public static bool IsPose(this in RigidTransform pose)
        {
            var r = pose;
            return double.IsFinite(r.X + r.Y + r.Z)
                && IsUnit(r.R00, r.R01, r.R02) && IsUnit(r.R10, r.R11, r.R12) && IsUnit(r.R20, r.R21, r.R22)
                && Determinant(r) > 0;
        }

        /// <summary>Metres between the origins.</summary>
        public static double DistanceTo(this in RigidTransform a, in RigidTransform b) => Length(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

        /// <summary>Radians by which one is turned against the other, 0 to π.</summary>
        public static double AngleTo(this in RigidTransform a, in RigidTransform b)
        {
            // Of the rotation aᵀb the antisymmetric part is the sine: the cosine alone says nothing below 1e-8.
            var (x, y, z) = TwiceSine(a, b);
            return Math.Atan2(Length(x, y, z) / 2, (Trace(a, b) - 1) / 2);
        }

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
