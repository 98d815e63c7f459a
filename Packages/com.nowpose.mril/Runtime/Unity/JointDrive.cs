using System;
using Nowpose.Kinematics;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Moves a transform relative to its parent according to the position of a joint.</summary>
    public sealed class JointDrive
    {
        readonly Transform _moved, _world;
        readonly bool _slides;
        readonly Vector3 _restPosition, _direction;
        readonly Quaternion _rest, _halfTurn;

        /// <summary>Constructs a drive whose transform is at the joint's origin when the joint position is 0.</summary>
        /// <param name="moved">The transform to move. Its parent represents the joint's parent link.</param>
        /// <param name="joint">A joint that is not fixed.</param>
        public JointDrive(Transform moved, RobotJoint joint)
            : this(moved, joint, UnityFrame.ToUnity(joint.Origin).Position(), UnityFrame.ToUnity(joint.Origin).Rotation()) { }

        /// <summary>Constructs a drive with a given pose for the joint position 0.</summary>
        /// <param name="moved">The transform to move.</param>
        /// <param name="joint">A joint that is not fixed. Its axis is given in the transform's own axes.</param>
        /// <param name="restPosition">Position of the transform at joint position 0, in its parent's axes, in metres.</param>
        /// <param name="restRotation">Rotation of the transform at joint position 0.</param>
        public JointDrive(Transform moved, RobotJoint joint, Vector3 restPosition, Quaternion restRotation)
            : this(moved, joint, restPosition, restRotation, null) { }

        /// <param name="restPosition">Position of the transform at joint position 0, in the units of its parent.</param>
        /// <param name="world">Transform whose units are metres; null if the units of the parent are metres.</param>
        internal JointDrive(Transform moved, RobotJoint joint, Vector3 restPosition, Quaternion restRotation, Transform world)
        {
            if (joint.Kind == JointKind.Fixed) throw new ArgumentException(RigMessages.FixedJoint(joint.Name), nameof(joint));
            _moved = moved;
            _world = world;
            _slides = joint.Kind == JointKind.Prismatic;
            _restPosition = restPosition;
            _rest = restRotation;
            _direction = restRotation * UnityFrame.DirectionToUnity(joint.Axis).Vector();
            var axis = UnityFrame.TurningAxisToUnity(joint.Axis).Vector();
            _halfTurn = restRotation * new Quaternion(axis.x, axis.y, axis.z, 0);
            moved.PlaceLocally(restPosition, restRotation);
        }

        /// <summary>Moves the transform to a joint position.</summary>
        /// <param name="position">Position of the joint in rad, or in m for a prismatic joint.</param>
        public void Apply(double position)
        {
            if (!_slides)
            {
                _moved.localRotation = Turned(position / 2);
                return;
            }
            var way = _direction * (float)position;
            _moved.localPosition = _restPosition + (_world == null ? way : way.InUnitsOfParent(_moved, _world));
        }

        // Computes the quaternion in double, because Unity's float degrees would cause a visible error at the end of a long arm.
        Quaternion Turned(double half)
        {
            float s = (float)Math.Sin(half), c = (float)Math.Cos(half);
            return new Quaternion(
                _rest.x * c + _halfTurn.x * s, _rest.y * c + _halfTurn.y * s, _rest.z * c + _halfTurn.z * s, _rest.w * c + _halfTurn.w * s);
        }
    }
}
