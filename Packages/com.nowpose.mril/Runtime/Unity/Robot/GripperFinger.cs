using System;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>One finger of a virtual gripper.</summary>
    [Serializable]
    public sealed class GripperFinger
    {
        [SerializeField, Tooltip("Name of the joint that moves this finger, as in the robot's URDF.")]
        string _joint = "";

        [SerializeField, Tooltip("What moves, as it stands at joint position 0 (closed, on the youBot), turned as the joint's own frame.")]
        Transform _finger = null;

        [NonSerialized] Pose _rest;
        [NonSerialized] bool _isRestKnown;

        public GripperFinger() { }

        public GripperFinger(string joint, Transform finger)
        {
            _joint = joint;
            _finger = finger;
        }

        public string Joint => _joint;
        public Transform Finger => _finger;

        /// <summary>Puts the finger back to where it stood when first asked: later it stands where a robot's joint left it.</summary>
        /// <returns>In its parent's axes.</returns>
        internal Pose Rest()
        {
            if (!_isRestKnown) _rest = new Pose(_finger.localPosition, _finger.localRotation);
            _isRestKnown = true;
            _finger.PlaceLocally(_rest.position, _rest.rotation);
            return _rest;
        }
    }
}
