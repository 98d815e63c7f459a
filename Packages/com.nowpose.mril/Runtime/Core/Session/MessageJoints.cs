using System;
using Nowpose.Kinematics;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>Which of the robot's joints a message is about. Looked up once for each array of names, which messages share. One thread.</summary>
    sealed class MessageJoints
    {
        /// <summary>As many as a <see cref="RosbridgeReader"/> remembers.</summary>
        const int Capacity = 4;

        readonly RobotModel _robot;
        readonly (string[] Names, int[] Joints)[] _known = new (string[], int[])[Capacity];
        int _next;

        public MessageJoints(RobotModel robot) => _robot = robot;

        /// <summary>Number of the robot's moving joints.</summary>
        public int RobotJoints => _robot.MovingJoints.Count;

        /// <summary>For each name of the message the index of the moving joint, -1 for a joint that is not the robot's. Until the next call.</summary>
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
