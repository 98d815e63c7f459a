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
            var q = UnitQuaternion.Of(pose);
            var sign = q.W < 0 ? -1 : 1;
            var at = DirectionToUnity((pose.X, pose.Y, pose.Z));
            var axis = TurningAxisToUnity((sign * q.X, sign * q.Y, sign * q.Z));
            return new UnityPose(at.X, at.Y, at.Z, axis.X, axis.Y, axis.Z, sign * q.W);
        }

        /// <param name="pose">A pose in Unity's axes; its rotation must not be zero, but need not be of unit length.</param>
        public static RigidTransform FromUnity(in UnityPose pose) =>
            UnitQuaternion.Normalised(-pose.RotationZ, pose.RotationX, -pose.RotationY, pose.RotationW).At(pose.Z, -pose.X, pose.Y);

        /// <summary>Converts a direction or a position of the URDF to Unity's axes.</summary>
        public static (double X, double Y, double Z) DirectionToUnity((double X, double Y, double Z) vector) =>
            (-vector.Y, vector.Z, vector.X);

        /// <summary>Converts a right-handed rotation axis of the URDF to the Unity axis of the same rotation by the same angle.</summary>
        public static (double X, double Y, double Z) TurningAxisToUnity((double X, double Y, double Z) axis) =>
            (axis.Y, -axis.Z, -axis.X);
    }
}
