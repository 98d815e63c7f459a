using System;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>A marker that is fixed to the robot's base, with the values entered in the Inspector.</summary>
    [Serializable]
    public sealed class AnchorMarker
    {
        [SerializeField, Tooltip("Text of the marker's code, case-sensitive.")]
        string _payload = "";

        [SerializeField, Tooltip("Position of the code's centre in the robot's base frame in metres: x forward, y left, z up.")]
        Vector3 _positionMetres = Vector3.zero;

        [SerializeField, Tooltip("Roll, pitch and yaw of the code in the robot's base frame in degrees, as in a URDF. All 0: the code lies face "
            + "up, and its text is read in the robot's x direction.")]
        Vector3 _turnedDegrees = Vector3.zero;

        [SerializeField, Tooltip("Edge length of the printed code without its white margin, in metres. 0: unknown; the measured size is not "
            + "checked.")]
        float _sizeMetres = 0;

        public AnchorMarker() { }

        /// <param name="positionMetres">Position in the robot's base frame, in metres.</param>
        /// <param name="turnedDegrees">Roll, pitch and yaw in the robot's base frame, in degrees.</param>
        public AnchorMarker(string payload, Vector3 positionMetres, Vector3 turnedDegrees, float sizeMetres = 0) =>
            (_payload, _positionMetres, _turnedDegrees, _sizeMetres) = (payload, positionMetres, turnedDegrees, sizeMetres);

        internal float SizeMetres => _sizeMetres;

        /// <summary>Pose in the robot's base frame.</summary>
        internal RigidTransform Place => RigidTransform.FromXyzRpy(
            _positionMetres.x, _positionMetres.y, _positionMetres.z,
            _turnedDegrees.x * Mathf.Deg2Rad, _turnedDegrees.y * Mathf.Deg2Rad, _turnedDegrees.z * Mathf.Deg2Rad);

        /// <summary>Converts the entered values to a marker.</summary>
        /// <exception cref="InputException">The payload is missing, or a number is out of range.</exception>
        public BaseMarker Read() => new BaseMarker(_payload, Place, _sizeMetres);
    }
}
