using System;

namespace Nowpose.Kinematics
{
    /// <summary>
    /// Converts between right-handed URDF poses (x forward, y left, z up) and Unity's left-handed poses. This is the only conversion.
    /// </summary>
    /// <remarks>
    /// Unity's (x, y, z) is (−y, z, x) of the URDF. This mapping is a reflection, so a rotation keeps its angle, and its axis maps with the
    /// opposite sign, to (y, −z, −x). The conversion keeps products: ToUnity(a * b) is ToUnity(a) followed by ToUnity(b).
    /// </remarks>
    public static class UnityFrame
    {
        /// <summary>Converts a pose to Unity's axes; the rotation has w ≥ 0.</summary>
        public static UnityPose ToUnity(in RigidTransform pose)
        {
            var (x, y, z, w) = Quaternion(pose);
            var at = DirectionToUnity((pose.X, pose.Y, pose.Z));
            var axis = TurningAxisToUnity((x, y, z));
            return new UnityPose(at.X, at.Y, at.Z, axis.X, axis.Y, axis.Z, w);
        }

        /// <param name="pose">A pose in Unity's axes; its rotation must not be zero, but need not be of unit length.</param>
        public static RigidTransform FromUnity(in UnityPose pose)
        {
            double x = -pose.RotationZ, y = pose.RotationX, z = -pose.RotationY, w = pose.RotationW;
            var s = 2 / (x * x + y * y + z * z + w * w);
            return new RigidTransform(
                1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w),
                s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w),
                s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y),
                pose.Z, -pose.X, pose.Y);
        }

        /// <summary>Converts a direction or a position of the URDF to Unity's axes.</summary>
        public static (double X, double Y, double Z) DirectionToUnity((double X, double Y, double Z) vector) =>
            (-vector.Y, vector.Z, vector.X);

        /// <summary>Converts a right-handed rotation axis of the URDF to the Unity axis of the same rotation by the same angle.</summary>
        public static (double X, double Y, double Z) TurningAxisToUnity((double X, double Y, double Z) axis) =>
            (axis.Y, -axis.Z, -axis.X);

        // Each branch divides by the largest of the four components, which is at least 1/2 (Shepperd's method).
        static (double X, double Y, double Z, double W) Quaternion(in RigidTransform r)
        {
            var trace = r.R00 + r.R11 + r.R22;
            if (trace >= r.R00 && trace >= r.R11 && trace >= r.R22)
                return Unit(r.R21 - r.R12, r.R02 - r.R20, r.R10 - r.R01, 1 + trace);
            if (r.R00 >= r.R11 && r.R00 >= r.R22)
                return Unit(1 + r.R00 - r.R11 - r.R22, r.R01 + r.R10, r.R02 + r.R20, r.R21 - r.R12);
            if (r.R11 >= r.R22)
                return Unit(r.R01 + r.R10, 1 + r.R11 - r.R00 - r.R22, r.R12 + r.R21, r.R02 - r.R20);
            return Unit(r.R02 + r.R20, r.R12 + r.R21, 1 + r.R22 - r.R00 - r.R11, r.R10 - r.R01);
        }

        static (double X, double Y, double Z, double W) Unit(double x, double y, double z, double w)
        {
            var scale = 1 / Math.Sqrt(x * x + y * y + z * z + w * w);
            if (w < 0) scale = -scale;
            return (x * scale, y * scale, z * scale, w * scale);
        }
    }
}
