using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Core's numbers as the engine's types. What they mean was settled by <see cref="UnityFrame"/>.</summary>
    public static class UnityPoses
    {
        internal static Vector3 Position(this in UnityPose pose) => new Vector3((float)pose.X, (float)pose.Y, (float)pose.Z);

        internal static Quaternion Rotation(this in UnityPose pose) => new Quaternion(
            (float)pose.RotationX, (float)pose.RotationY, (float)pose.RotationZ, (float)pose.RotationW);

        /// <summary>A place in Unity's world in the room frame: the same origin, the URDF's axes.</summary>
        /// <param name="rotation">Of any length but zero.</param>
        public static RigidTransform ToRoom(Vector3 position, Quaternion rotation) => UnityFrame.FromUnity(
            new UnityPose(position.x, position.y, position.z, rotation.x, rotation.y, rotation.z, rotation.w));

        /// <summary>A pose in the room frame as a place in Unity's world.</summary>
        public static Pose ToWorld(in RigidTransform room)
        {
            var pose = UnityFrame.ToUnity(room);
            return new Pose(pose.Position(), pose.Rotation());
        }

        /// <summary>Both at once, in the parent's axes; the engine's own call for it is missing before 2021.3.11.</summary>
        internal static void PlaceLocally(this Transform moved, Vector3 position, Quaternion rotation)
        {
            moved.localPosition = position;
            moved.localRotation = rotation;
        }

        /// <summary>Puts a transform to a URDF origin in its parent's axes.</summary>
        internal static void Place(this Transform moved, in RigidTransform origin)
        {
            var pose = UnityFrame.ToUnity(origin);
            moved.PlaceLocally(pose.Position(), pose.Rotation());
        }

        internal static Vector3 Vector(this (double X, double Y, double Z) triple) =>
            new Vector3((float)triple.X, (float)triple.Y, (float)triple.Z);
    }
}
