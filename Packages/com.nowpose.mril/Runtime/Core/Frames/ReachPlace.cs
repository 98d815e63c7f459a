using Nowpose.Kinematics;

namespace Nowpose.Frames
{
    /// <summary>
    /// Place that a gripper assigns to an object in place of the object's own source: in the gripper, or at the position of the release.
    /// </summary>
    sealed class ReachPlace
    {
        /// <param name="gripper">The gripper that determines the place.</param>
        /// <param name="parent">The gripper's link, or the world.</param>
        /// <param name="pose">Constant pose of the object relative to the parent.</param>
        /// <param name="since">Time stamp of the change of the gripper's signal.</param>
        /// <param name="isReleased">
        /// Whether the gripper has released the object. The object then keeps this pose until its source reports another one.
        /// </param>
        public ReachPlace(ReachGrip gripper, string parent, in RigidTransform pose, ControlTime since, bool isReleased) =>
            (Gripper, Parent, Pose, Since, IsReleased) = (gripper, parent, pose, since, isReleased);

        public ReachGrip Gripper { get; }

        public string Parent { get; }

        public RigidTransform Pose { get; }

        /// <summary>Time stamp of the change of the gripper's signal; a time before all poses after <see cref="ForgetTime"/>.</summary>
        public ControlTime Since { get; private set; }

        public bool IsReleased { get; }

        /// <summary>Discards the time, because the times of the control system have become invalid.</summary>
        public void ForgetTime() => Since = default;
    }
}
