using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Core's numbers as the engine's types. What they mean was settled by <see cref="UnityFrame"/>.</summary>
    static class UnityPoses
    {
        public static Vector3 Position(this in UnityPose pose) => new Vector3((float)pose.X, (float)pose.Y, (float)pose.Z);

        public static Quaternion Rotation(this in UnityPose pose) => new Quaternion(
            (float)pose.RotationX, (float)pose.RotationY, (float)pose.RotationZ, (float)pose.RotationW);

        /// <summary>Both at once, in the parent's axes; the engine's own call for it is missing before 2021.3.11.</summary>
        public static void PlaceLocally(this Transform moved, Vector3 position, Quaternion rotation)
        {
            moved.localPosition = position;
            moved.localRotation = rotation;
        }

        /// <summary>Puts a transform to a URDF origin in its parent's axes.</summary>
        public static void Place(this Transform moved, in RigidTransform origin)
        {
            var pose = UnityFrame.ToUnity(origin);
            moved.PlaceLocally(pose.Position(), pose.Rotation());
        }

        public static Vector3 Vector(this (double X, double Y, double Z) triple) =>
            new Vector3((float)triple.X, (float)triple.Y, (float)triple.Z);
    }
}
