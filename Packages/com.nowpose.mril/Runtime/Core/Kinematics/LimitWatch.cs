using System;
using System.Collections.Generic;

namespace Nowpose.Kinematics
{
    /// <summary>Finds joints whose samples lie where the robot's description does not let them be: another robot's, or another unit.</summary>
    /// <remarks>
    /// A joint is beyond its limits from the third sample in a row that is, and until a hundred in a row are not, so that a joint
    /// that swings is said once. Noise at a stop, and limits that are rounded, do not count: 0.02 rad or 2 mm. Allocates only where
    /// it finds a joint for the first time; not thread-safe.
    /// </remarks>
    sealed class LimitWatch
    {
        const double ToleranceRadians = 0.02, ToleranceMetres = 0.002;
        const int SamplesToFind = 3, SamplesToForget = 100;

        readonly IReadOnlyList<RobotJoint> _joints;
        readonly JointBeyondLimits[] _beyond;
        readonly bool[] _isBeyond;
        readonly int[] _inARow;
        readonly List<JointBeyondLimits> _found = new List<JointBeyondLimits>();

        public LimitWatch(RobotModel robot)
        {
            _joints = robot.MovingJoints;
            _beyond = new JointBeyondLimits[_joints.Count];
            _isBeyond = new bool[_joints.Count];
            _inARow = new int[_joints.Count];
        }

        /// <summary>All that were ever found, in that order, each joint once.</summary>
        public IReadOnlyList<JointBeyondLimits> Found => _found;

        /// <summary>The first that is beyond its limits now, in the robot's order; null for none.</summary>
        public JointBeyondLimits Present
        {
            get
            {
                var first = Array.IndexOf(_isBeyond, true);
                return first < 0 ? null : _beyond[first];
            }
        }

        /// <summary>Whether a joint is beyond its limits now.</summary>
        public bool IsBeyond(JointBeyondLimits found) => _isBeyond[found.Joint.MovingIndex];

        /// <param name="joint">Index among the moving ones.</param>
        /// <param name="position">Of a sample, rad or m.</param>
        public void Add(int joint, double position)
        {
            // Of samples that say otherwise than before.
            _inARow[joint] = IsOutside(_joints[joint], position) == _isBeyond[joint] ? 0 : _inARow[joint] + 1;
            if (_inARow[joint] < (_isBeyond[joint] ? SamplesToForget : SamplesToFind)) return;
            _inARow[joint] = 0;
            _isBeyond[joint] = !_isBeyond[joint];
            if (!_isBeyond[joint] || _beyond[joint] != null) return;
            _beyond[joint] = new JointBeyondLimits(_joints[joint], position);
            _found.Add(_beyond[joint]);
        }

        static bool IsOutside(RobotJoint joint, double position)
        {
            var tolerance = joint.Kind == JointKind.Prismatic ? ToleranceMetres : ToleranceRadians;
            return position < joint.Limits.Lower - tolerance || position > joint.Limits.Upper + tolerance;
        }
    }
}
