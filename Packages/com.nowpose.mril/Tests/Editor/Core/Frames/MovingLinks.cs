using System;
using Nowpose.Frames;
using Nowpose.Kinematics;

namespace Nowpose.Tests.Core.Frames
{
    /// <summary>A robot whose links a test puts where it wants.</summary>
    sealed class MovingLinks : IRobotLinks
    {
        readonly RigidTransform[] _poses;

        public MovingLinks(string robot, RobotModel model)
        {
            Namespace = robot;
            Robot = model;
            _poses = new RigidTransform[model.Links.Count];
            Array.Fill(_poses, RigidTransform.Identity);
        }

        public string Namespace { get; }

        public RobotModel Robot { get; }

        public bool IsCurrent { get; set; } = true;

        public ReadOnlySpan<RigidTransform> Poses => _poses;

        /// <returns>The same pose.</returns>
        public RigidTransform Move(int link, in RigidTransform pose) => _poses[link] = pose;
    }
}
