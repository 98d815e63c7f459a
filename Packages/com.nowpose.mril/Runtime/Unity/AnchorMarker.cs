using System;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>A marker that is fixed to the robot's base, as entered in the Inspector.</summary>
    [Serializable]
    public sealed class AnchorMarker
    {
        [SerializeField, Tooltip("Text of its code, letter for letter.")]
        string _payload = "";

        [SerializeField, Tooltip("Where the centre of the code is in the robot's base frame, x forward, y left, z up, metres.")]
        Vector3 _positionMetres = Vector3.zero;

        [SerializeField, Tooltip("Roll, pitch and yaw of the code in the robot's base frame as in a URDF, degrees. All 0: it lies face up, and "
            + "its text is read from left to right along the robot's x.")]
        Vector3 _turnedDegrees = Vector3.zero;

        [SerializeField, Tooltip("Edge of the printed code without its white margin, metres. 0: not known, and not compared with what is seen.")]
        float _sizeMetres = 0;

        public AnchorMarker() { }

        /// <param name="positionMetres">Position in the robot's base frame, in metres.</param>
        /// <param name="turnedDegrees">Roll, pitch and yaw in degrees.</param>
        public AnchorMarker(string payload, Vector3 positionMetres, Vector3 turnedDegrees, float sizeMetres = 0)
        {
            _payload = payload;
            _positionMetres = positionMetres;
            _turnedDegrees = turnedDegrees;
            _sizeMetres = sizeMetres;
        }

        internal float SizeMetres => _sizeMetres;

        /// <summary>Pose in the robot's base frame.</summary>
        internal RigidTransform Place => RigidTransform.FromXyzRpy(
            _positionMetres.x, _positionMetres.y, _positionMetres.z,
            _turnedDegrees.x * Mathf.Deg2Rad, _turnedDegrees.y * Mathf.Deg2Rad, _turnedDegrees.z * Mathf.Deg2Rad);

        /// <exception cref="InputException">The payload is missing, or a number is out of range.</exception>
        public BaseMarker Read() => new BaseMarker(_payload, Place, _sizeMetres);
    }
}
