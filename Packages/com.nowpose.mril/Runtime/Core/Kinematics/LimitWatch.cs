using System.Collections.Generic;

namespace Nowpose.Kinematics
{
    /// <summary>
    /// Detects joints whose samples are outside the limits of the robot description, which indicates a different robot or a different unit.
    /// </summary>
    /// <remarks>
    /// A joint is beyond its limits after three consecutive samples outside them, until a hundred consecutive samples are inside them. A
    /// joint that oscillates about a limit is therefore reported once. A tolerance of 0.02 rad or 2 mm covers noise at a stop and rounded
    /// limits. Allocates only at the first detection of a joint; not thread-safe.
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

        /// <summary>All joints detected so far, each once, in the order of detection.</summary>
        public IReadOnlyList<JointBeyondLimits> Found => _found;

        /// <summary>The first joint in the robot's order that is beyond its limits now; null if there is none.</summary>
        public JointBeyondLimits Present
        {
            get
            {
                // Array.IndexOf with an array of bool reads beyond its end on Mono and can end the process.
                for (var joint = 0; joint < _isBeyond.Length; joint++)
                    if (_isBeyond[joint]) return _beyond[joint];
                return null;
            }
        }

        /// <summary>Returns whether a joint is beyond its limits now.</summary>
        public bool IsBeyond(JointBeyondLimits found) => _isBeyond[found.Joint.MovingIndex];

        /// <param name="joint">Index among the moving joints.</param>
        /// <param name="position">Position of a sample, in rad or m.</param>
        public void Add(int joint, double position)
        {
            // Counts the consecutive samples that contradict the current state.
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
