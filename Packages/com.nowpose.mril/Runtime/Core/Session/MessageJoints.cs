using System;
using Nowpose.Kinematics;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>Maps the joint names of messages to the robot's joints. Caches the results for recent arrays of names. Single-threaded.</summary>
    sealed class MessageJoints
    {
        /// <summary>Number of cached arrays of names, the same as in <see cref="RosbridgeReader"/>.</summary>
        const int Capacity = 4;

        readonly RobotModel _robot;
        readonly (string[] Names, int[] Joints)[] _known = new (string[], int[])[Capacity];
        int _next;

        public MessageJoints(RobotModel robot) => _robot = robot;

        /// <summary>Number of the robot's moving joints.</summary>
        public int RobotJoints => _robot.MovingJoints.Count;

        /// <summary>Returns the index of the moving joint for each name, −1 for an unknown name. Valid until the next call.</summary>
        public ReadOnlySpan<int> Of(JointStateMessage message)
        {
            foreach (var known in _known)
                if (known.Names == message.Names) return known.Joints;
            ref var place = ref _known[_next];
            _next = (_next + 1) % Capacity;
            if (place.Joints?.Length != message.Names.Length) place.Joints = new int[message.Names.Length];
            place.Names = message.Names;
            for (var i = 0; i < place.Joints.Length; i++) place.Joints[i] = _robot.IndexOfMovingJoint(message.Names[i]);
            return place.Joints;
        }
    }
}
