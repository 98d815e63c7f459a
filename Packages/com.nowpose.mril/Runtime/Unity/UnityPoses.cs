using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Converts between the poses of Core and the types of Unity. <see cref="UnityFrame"/> converts the axes.</summary>
    public static class UnityPoses
    {
        internal static Vector3 Position(this in UnityPose pose) => new Vector3((float)pose.X, (float)pose.Y, (float)pose.Z);

        internal static Quaternion Rotation(this in UnityPose pose) => new Quaternion(
            (float)pose.RotationX, (float)pose.RotationY, (float)pose.RotationZ, (float)pose.RotationW);

        /// <summary>Converts a pose in Unity's world to the room frame, which has the same origin and URDF axes.</summary>
        /// <param name="position">Position in metres.</param>
        /// <param name="rotation">Rotation as a quaternion of any length except zero.</param>
        public static RigidTransform ToRoom(Vector3 position, Quaternion rotation) => UnityFrame.FromUnity(
            new UnityPose(position.x, position.y, position.z, rotation.x, rotation.y, rotation.z, rotation.w));

        /// <summary>Converts a pose in the room frame to Unity's world.</summary>
        public static Pose ToWorld(in RigidTransform room)
        {
            var pose = UnityFrame.ToUnity(room);
            return new Pose(pose.Position(), pose.Rotation());
        }

        /// <summary>Sets position and rotation relative to the parent. Unity's own method for this exists only since 2021.3.11.</summary>
        internal static void PlaceLocally(this Transform moved, Vector3 position, Quaternion rotation)
        {
            moved.localPosition = position;
            moved.localRotation = rotation;
        }

        /// <summary>
        /// Moves a transform to a pose relative to its parent. Like an origin in a URDF, the pose is right-handed and in URDF axes.
        /// </summary>
        internal static void Place(this Transform moved, in RigidTransform origin)
        {
            var pose = UnityFrame.ToUnity(origin);
            moved.PlaceLocally(pose.Position(), pose.Rotation());
        }

        internal static Vector3 Vector(this (double X, double Y, double Z) triple) =>
            new Vector3((float)triple.X, (float)triple.Y, (float)triple.Z);
    }
}
