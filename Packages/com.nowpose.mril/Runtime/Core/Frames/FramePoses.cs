using Nowpose.Kinematics;
using Nowpose.Protocol.Cell;

namespace Nowpose.Frames
{
    /// <summary>Converts poses to and from the form in which they are sent.</summary>
    static class FramePoses
    {
        /// <param name="pose">Pose of the child in its parent.</param>
        public static FrameTransform ToTransform(this in RigidTransform pose, ControlTime stamp, string parent, string child)
        {
            var rotation = UnitQuaternion.Of(pose);
            return new FrameTransform(stamp, parent, child, pose.X, pose.Y, pose.Z, rotation.X, rotation.Y, rotation.Z, rotation.W);
        }

        /// <returns>Pose of the child in its parent.</returns>
        public static RigidTransform ToPose(this in FrameTransform transform)
        {
            UnitQuaternion.TryNormalise(transform.Qx, transform.Qy, transform.Qz, transform.Qw, out var rotation);
            return rotation.At(transform.X, transform.Y, transform.Z);
        }
    }
}
