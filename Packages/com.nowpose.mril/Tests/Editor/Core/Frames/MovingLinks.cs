using System;
using Nowpose.Frames;
using Nowpose.Kinematics;

namespace Nowpose.Tests.Core.Frames
{
    /// <summary>A robot whose links are placed by a test.</summary>
    sealed class MovingLinks : IRobotLinks
    {
        readonly RigidTransform[] _poses;
        readonly RigidTransform[] _held;

        public MovingLinks(string robot, RobotModel model)
        {
            Namespace = robot;
            Robot = model;
            _poses = new RigidTransform[model.Links.Count];
            Array.Fill(_poses, RigidTransform.Identity);
            _held = (RigidTransform[])_poses.Clone();
        }

        public string Namespace { get; }

        public RobotModel Robot { get; }

        public bool IsCurrent { get; set; } = true;

        public bool IsCurrentAt(int link) => IsCurrent;

        public ReadOnlySpan<RigidTransform> Poses => _poses;

        public ReadOnlySpan<RigidTransform> HeldPoses => _held;

        /// <summary>
        /// Function that returns the pose of a link at a given time, and its origin; null to return the poses of <see cref="Poses"/> with the origin
        /// Measured.
        /// </summary>
        public Func<int, ControlTime, (RigidTransform Pose, PoseOrigin Origin)> Past { get; set; }

        public RigidTransform PoseAt(int link, ControlTime at, out PoseOrigin origin)
        {
            var (pose, known) = Past?.Invoke(link, at) ?? (_poses[link], PoseOrigin.Measured);
            origin = known;
            return pose;
        }

        /// <returns>The same pose.</returns>
        public RigidTransform Hold(int link, in RigidTransform pose) => _held[link] = pose;

        /// <returns>The same pose.</returns>
        public RigidTransform Move(int link, in RigidTransform pose) => _poses[link] = pose;
    }
}
