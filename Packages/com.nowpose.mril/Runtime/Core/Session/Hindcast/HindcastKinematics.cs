using System;
using Nowpose.Kinematics;

namespace Nowpose.Session.Hindcast
{
    /// <summary>Computes tool poses for joint positions other than the displayed positions. Allocates nothing after construction.</summary>
    sealed class HindcastKinematics
    {
        readonly RobotModel _robot;
        readonly ForwardKinematics _kinematics;
        readonly int _toolLink;
        readonly int[] _joints;
        readonly bool[] _given;
        readonly double[] _positions;
        readonly RigidTransform[] _linkPoses;

        /// <param name="joints">Indices of the joints with true positions, and of mimic joints, which have true positions if they are given.</param>
        public HindcastKinematics(RobotModel robot, int[] joints)
        {
            _robot = robot;
            _kinematics = new ForwardKinematics(robot);
            _toolLink = robot.IndexOfLink(robot.ToolLink.Name);
            _joints = joints;
            _given = new bool[robot.MovingJoints.Count];
            for (var i = 0; i < _given.Length; i++) _given[i] = robot.MovingJoints[i].Mimic == null;
            _positions = new double[robot.MovingJoints.Count];
            _linkPoses = new RigidTransform[robot.Links.Count];
        }

        /// <summary>Sets whether a mimic joint has a true position of its own. Otherwise, its position follows from that of its master.</summary>
        public void SetGiven(int joint, bool isGiven) => _given[joint] = isGiven;

        /// <param name="positions">Positions of all moving joints.</param>
        public RigidTransform ToolOf(ReadOnlySpan<double> positions)
        {
            _kinematics.Compute(positions, _linkPoses);
            return _linkPoses[_toolLink];
        }

        /// <summary>Computes the tool pose from the true joint positions.</summary>
        /// <param name="addsUncertainty">Whether the uncertainty of each joint is added to its position.</param>
        public RigidTransform ToolOf(ReadOnlySpan<ShownFrames.JointValues> truth, bool addsUncertainty)
        {
            for (var i = 0; i < _joints.Length; i++) _positions[_joints[i]] = truth[i].Truth + (addsUncertainty ? truth[i].Uncertainty : 0);
            _robot.CompleteMimics(_positions, _given);
            return ToolOf(_positions);
        }
    }
}
