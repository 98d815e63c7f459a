namespace Nowpose.Kinematics
{
    /// <summary>A pose in Unity's left-handed frame (x right, y up, z forward) as numbers, because Core has no engine types.</summary>
    public readonly struct UnityPose
    {
        public UnityPose(double x, double y, double z, double rotationX, double rotationY, double rotationZ, double rotationW)
        {
            X = x;
            Y = y;
            Z = z;
            RotationX = rotationX;
            RotationY = rotationY;
            RotationZ = rotationZ;
            RotationW = rotationW;
        }

        /// <summary>X coordinate of the position, in metres; <see cref="Y"/> and <see cref="Z"/> likewise.</summary>
        public double X { get; }

        public double Y { get; }
        public double Z { get; }

        /// <summary>Component of the rotation's unit quaternion, as in Unity's <c>Quaternion</c>.</summary>
        public double RotationX { get; }

        public double RotationY { get; }
        public double RotationZ { get; }
        public double RotationW { get; }
    }
}
