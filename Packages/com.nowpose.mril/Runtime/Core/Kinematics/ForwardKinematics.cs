using System;
using Nowpose.Messages;

namespace Nowpose.Kinematics
{
    /// <summary>Computes the poses of all links from the joint positions.</summary>
    /// <remarks>The constructor computes all constants. Immutable afterwards and thread-safe.</remarks>
    sealed class ForwardKinematics
    {
        readonly RobotModel _model;
        readonly JointMotion[] _motions;

        public ForwardKinematics(RobotModel model)
        {
            _model = model;
            _motions = new JointMotion[model.Links.Count - 1];
            for (var i = 0; i < _motions.Length; i++) _motions[i] = new JointMotion(model.Links[i + 1]);
        }

        /// <summary>Computes poses relative to the root link, right-handed as in the URDF. Ignores limits; allocates nothing.</summary>
        /// <param name="positions">One position per element of <see cref="RobotModel.MovingJoints"/>, in rad or m, including mimic joints.</param>
        /// <param name="linkPoses">Receives one pose per element of <see cref="RobotModel.Links"/>, in that order.</param>
        public void Compute(ReadOnlySpan<double> positions, Span<RigidTransform> linkPoses)
        {
            _model.RequireOnePerMovingJoint(positions.Length, nameof(positions));
            if (linkPoses.Length != _motions.Length + 1)
                throw new ArgumentException(RobotMessages.PoseCount(linkPoses.Length, _motions.Length + 1), nameof(linkPoses));

            linkPoses[0] = RigidTransform.Identity;
            for (var i = 0; i < _motions.Length; i++)
            {
                ref readonly var motion = ref _motions[i];
                ref readonly var parent = ref linkPoses[motion.Parent];
                linkPoses[i + 1] = motion.Kind switch
                {
                    JointKind.Fixed => parent * motion.Origin,
                    JointKind.Prismatic => parent * motion.SlidBy(positions[motion.Position]),
                    _ => parent * motion.TurnedBy(positions[motion.Position]),
                };
            }
        }
    }
}
