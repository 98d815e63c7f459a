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

        [SerializeField, Tooltip("The object that moves. Place it where it is at joint position 0 (closed on the youBot), with its axes "
            + "parallel to those of the joint's frame.")]
        Transform _finger = null;

        public GripperFinger() { }

        public GripperFinger(string joint, Transform finger) => (_joint, _finger) = (joint, finger);

        public string Joint => _joint;
        public Transform Finger => _finger;
    }
}
