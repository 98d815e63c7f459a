using System;
using System.Collections.Concurrent;

namespace Nowpose.Session
{
    /// <summary>The messages that wait for a frame, and which of them are worth the frame's time. Allocates nothing once made; one thread.</summary>
    /// <remarks>
    /// After a frame that hung, or a network that did, a thousand messages may wait. Solving a joint's sample takes some 40 µs
    /// with the default predictor: of seven joints, all of them would take a quarter of a second, and the next frame hung again.
    /// </remarks>
    sealed class SampleBacklog
    {
        /// <summary>Up to so many messages are taken as they are: a source at 1 kHz leaves 17 for a frame at 60 Hz.</summary>
        const int MostOfAUsualFrame = 30;

        /// <summary>
        /// Of more, only each joint's newest so many: 6 ms for seven joints. Predictions look back over fewer, and a joint that
        /// speaks seldom, a gripper, loses nothing.
        /// </summary>
        const int NewestOfAJoint = 20;

        readonly MessageJoints _joints;
        readonly SampleArrival[] _oldestFirst;
        readonly bool[] _isWorthwhile;
        readonly int[] _samplesOfJoint;

        /// <param name="capacity">So many messages at most are taken from the queue at a time.</param>
        public SampleBacklog(MessageJoints joints, int capacity)
        {
            _joints = joints;
            _oldestFirst = new SampleArrival[capacity];
            _isWorthwhile = new bool[capacity];
            _samplesOfJoint = new int[joints.RobotJoints];
        }

        public int Count { get; private set; }

        /// <summary>The oldest first.</summary>
        public ref readonly SampleArrival this[int index] => ref _oldestFirst[index];

        public bool IsWorthwhile(int index) => _isWorthwhile[index];

        public void TakeFrom(ConcurrentQueue<SampleArrival> queue)
        {
            Count = 0;
            while (Count < _oldestFirst.Length && queue.TryDequeue(out var arrival)) _oldestFirst[Count++] = arrival;
            Array.Clear(_samplesOfJoint, 0, _samplesOfJoint.Length);
            for (var i = Count - 1; i >= 0; i--) _isWorthwhile[i] = Count <= MostOfAUsualFrame || HasNewSample(i);
        }

        /// <summary>Lets go of the messages.</summary>
        public void Clear()
        {
            Array.Clear(_oldestFirst, 0, Count);
            Count = 0;
        }

        // Counts each joint's samples from the newest back.
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
