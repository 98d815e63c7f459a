using System;
using System.Collections.Generic;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>
    /// Takes the messages that were queued for a frame, and selects the messages to process. Allocates nothing after construction; single-threaded.
    /// </summary>
    /// <remarks>
    /// After a delay of the network or of a frame, a thousand messages may wait. A joint's sample takes about 5 µs with the default predictor, so
    /// processing a thousand messages of seven joints takes as long as two frames and would delay the next frame again.
    /// </remarks>
    sealed class SampleBacklog
    {
        /// <summary>
        /// Maximum number of messages that are processed without selection. At 60 frames per second, a source at 1 kHz sends 17 messages
        /// per frame.
        /// </summary>
        const int MaxUsualCount = 30;

        /// <summary>
        /// Number of newest samples of each joint that are processed if more messages wait: less than 1 ms for seven joints. Predictions use fewer
        /// samples, and a joint that is sent rarely, such as a gripper, loses no samples.
        /// </summary>
        const int NewestOfAJoint = 20;

        readonly MessageJoints _joints;
        readonly List<Arrival<JointStateMessage>> _oldestFirst;
        readonly bool[] _isSelected;
        readonly int[] _samplesOfJoint;

        /// <param name="capacity">Maximum number of messages taken from the queue at a time.</param>
        public SampleBacklog(MessageJoints joints, int capacity)
        {
            _joints = joints;
            _oldestFirst = new List<Arrival<JointStateMessage>>(capacity);
            _isSelected = new bool[capacity];
            _samplesOfJoint = new int[joints.RobotJoints];
        }

        public int Count => _oldestFirst.Count;

        /// <summary>Messages by index, oldest first.</summary>
        public Arrival<JointStateMessage> this[int index] => _oldestFirst[index];

        public bool IsSelected(int index) => _isSelected[index];

        public void TakeFrom(Arrivals<JointStateMessage> arrivals)
        {
            arrivals.TakeAll(_oldestFirst);
            Array.Clear(_samplesOfJoint, 0, _samplesOfJoint.Length);
            for (var i = Count - 1; i >= 0; i--) _isSelected[i] = Count <= MaxUsualCount || HasNewSample(i);
        }

        // Called for the messages from the newest to the oldest, so that the newest samples of each joint are counted first.
        bool HasNewSample(int index)
        {
            var isNew = false;
            foreach (var joint in _joints.Of(_oldestFirst[index].Message))
            {
                if (joint >= 0) isNew |= ++_samplesOfJoint[joint] <= NewestOfAJoint;
            }
            return isNew;
        }
    }
}
