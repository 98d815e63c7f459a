using System.Collections.Generic;
using Nowpose.Kinematics;

namespace Nowpose.Frames
{
    /// <summary>Poses in the world at the stamp of a change of a gripper's signal: of the gripping point and of the objects.</summary>
    /// <remarks>
    /// A predicted pose is computed again until samples from after the stamp have arrived. The pose from these samples is kept, because the samples
    /// are discarded later. Allocates memory only when the number of objects grows.
    /// </remarks>
    sealed class PosesAtChange
    {
        readonly FrameTree _tree;
        readonly IRobotLinks _robot;
        readonly int _link;
        readonly Dictionary<CellFrame, (KnownPose Pose, ReachPlace Place)> _objects = new Dictionary<CellFrame, (KnownPose, ReachPlace)>();

        /// <param name="link">Index of the link in the robot; its origin is the gripping point.</param>
        public PosesAtChange(FrameTree tree, IRobotLinks robot, int link) => (_tree, _robot, _link) = (tree, robot, link);

        /// <summary>Stamp of the change.</summary>
        public ControlTime At { get; private set; }

        /// <summary>Pose of the gripping point, according to the last <see cref="UpdateHand"/>.</summary>
        public KnownPose Hand { get; private set; }

        /// <summary>Discards all poses after a new change.</summary>
        public void Begin(ControlTime at)
        {
            At = at;
            Hand = default;
            _objects.Clear();
        }

        /// <summary>Computes the pose of the gripping point from the samples that have arrived.</summary>
        /// <returns>Whether samples from after the stamp have arrived since the last call.</returns>
        public bool UpdateHand()
        {
            if (Hand.IsMeasured) return false;
            var pose = _tree.LinkAt(_tree.IndexOf(_robot), _link, At, out var origin);
            if (origin != PoseOrigin.None) Hand = new KnownPose(pose, origin);
            return Hand.IsMeasured;
        }

        /// <summary>Returns the pose of an object, computed from the samples that have arrived.</summary>
        /// <param name="index">Index of the object's frame.</param>
        /// <param name="reach">Place that a gripper assigned to the object before the change; null if the object's source determines its place.</param>
        public KnownPose Of(int index, ReachPlace reach)
        {
            var frame = _tree[index];
            if (_objects.TryGetValue(frame, out var known) && known.Pose.IsMeasured && known.Place == reach) return known.Pose;
            var pose = _tree.PoseAt(index, reach, At, out var origin);
            if (origin != PoseOrigin.None) _objects[frame] = known = (new KnownPose(pose, origin), reach);
            return known.Pose;
        }

        /// <summary>Returns whether the pose of an object is known, and was computed with the given place.</summary>
        /// <inheritdoc cref="Of"/>
        public bool IsOf(int index, ReachPlace reach) => _objects.TryGetValue(_tree[index], out var known) && known.Place == reach;

        /// <summary>
        /// Adds the poses of all other frames of the tree that are out of reach. They are not in the gripper, also if they can be gripped later.
        /// </summary>
        /// <param name="reach">Maximum distance of an object's origin from the gripping point, m.</param>
        public void AddOutOfReach(double reach)
        {
            for (var i = 0; i < _tree.Count; i++)
            {
                var (frame, place) = (_tree[i], _tree[i].Reach);
                if (_objects.ContainsKey(frame)) continue;
                var pose = new KnownPose(_tree.PoseAt(i, place, At, out var origin), origin);
                var nearest = new NearestObject(Hand, reach);
                nearest.Add(i, frame.Name, pose);
                if (pose.IsKnown && nearest.Index < 0) _objects.Add(frame, (pose, place));
            }
        }

        /// <summary>Returns whether the pose of an object is known.</summary>
        public bool Includes(CellFrame frame) => _objects.ContainsKey(frame);
    }

    /// <summary>A pose and its origin; <c>default</c> for an unknown pose.</summary>
    readonly struct KnownPose
    {
        public KnownPose(in RigidTransform pose, PoseOrigin origin) => (Pose, Origin) = (pose, origin);

        public RigidTransform Pose { get; }

        public PoseOrigin Origin { get; }

        public bool IsKnown => Origin != PoseOrigin.None;

        public bool IsMeasured => Origin == PoseOrigin.Measured;
    }
}
