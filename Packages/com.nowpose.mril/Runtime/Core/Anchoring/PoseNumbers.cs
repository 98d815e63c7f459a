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
        public static double AngleTo(this in RigidTransform a, in RigidTransform b) =>
            UnitQuaternion.AngleBetween(UnitQuaternion.Of(a), UnitQuaternion.Of(b));

        /// <summary>Returns the rotation vector: its direction is the axis, and its length is the angle, up to π rad.</summary>
        public static Vector3D RotationVector(this in RigidTransform pose) => UnitQuaternion.Of(pose).Log();

        /// <summary>Returns the rotation that a rotation vector in rad describes.</summary>
        public static RigidTransform Turn(double x, double y, double z) => UnitQuaternion.Exp(new Vector3D(x, y, z)).At(0, 0, 0);

        /// <summary>Interpolates between two poses: linearly in position, at a constant rate in rotation.</summary>
        /// <param name="part">Fraction of the way from <paramref name="from"/> to <paramref name="to"/>, 0 to 1.</param>
        public static RigidTransform Between(in RigidTransform from, in RigidTransform to, double part)
        {
            var turn = (from.Inverse * to).RotationVector() * part;
            return (from * Turn(turn.X, turn.Y, turn.Z)).MovedTo(
                from.X + (to.X - from.X) * part, from.Y + (to.Y - from.Y) * part, from.Z + (to.Z - from.Z) * part);
        }

        /// <summary>Returns the same rotation with another translation.</summary>
        public static RigidTransform MovedTo(this in RigidTransform pose, double x, double y, double z) => new RigidTransform(
            pose.R00, pose.R01, pose.R02, pose.R10, pose.R11, pose.R12, pose.R20, pose.R21, pose.R22, x, y, z);

        public static double Length(double x, double y, double z) => Math.Sqrt(x * x + y * y + z * z);

        static double Determinant(in RigidTransform r) =>
            r.R00 * (r.R11 * r.R22 - r.R12 * r.R21) - r.R01 * (r.R10 * r.R22 - r.R12 * r.R20) + r.R02 * (r.R10 * r.R21 - r.R11 * r.R20);

        static bool IsUnit(double x, double y, double z) => Math.Abs(Length(x, y, z) - 1) < Unit;
    }
}
