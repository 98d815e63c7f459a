using System;
using Nowpose.Kinematics;

namespace Nowpose.Session.Hindcast
{
    /// <summary>Queue of displayed frames that wait for samples with the true joint positions. Allocates nothing after construction.</summary>
    sealed class ShownFrames
    {
        /// <summary>Capacity in frames: more than four seconds at 120 frames per second. Drops the oldest when full.</summary>
        const int Capacity = 512;

        readonly int _jointCount;
        readonly Frame[] _frames = new Frame[Capacity];
        readonly JointValues[] _joints;
        int _first, _count;

        /// <param name="jointCount">Maximum number of joints whose true positions are needed for each frame.</param>
        public ShownFrames(int jointCount)
        {
            _jointCount = jointCount;
            _joints = new JointValues[Capacity * jointCount];
        }

        /// <param name="state">State of the frame's pose.</param>
        /// <param name="isToolKnown">Whether the error of the tool can be computed, and not only those of the joints.</param>
        /// <param name="displayed">Displayed tool pose.</param>
        /// <param name="held">Tool pose from the newest samples without compensation.</param>
        /// <param name="clockError">Error bound of the clock, s.</param>
        /// <param name="needed">Number of joints whose true positions are needed.</param>
        /// <returns>Buffer for the displayed and uncompensated positions of the joints.</returns>
        public Span<JointValues> Add(
            ControlTime at, PoseState state, bool isToolKnown, in RigidTransform displayed, in RigidTransform held, double clockError, int needed)
        {
            if (_count == Capacity) RemoveFirst();
            var index = (_first + _count++) % Capacity;
            _frames[index] = new Frame
            {
                At = at, State = state, IsToolKnown = isToolKnown, Missing = needed, ClockError = clockError,
                X = displayed.X, Y = displayed.Y, Z = displayed.Z, HeldX = held.X, HeldY = held.Y, HeldZ = held.Z,
            };
            return _joints.AsSpan(index * _jointCount, _jointCount);
        }

        /// <summary>Sets the true position of a joint for the frames within a span.</summary>
        /// <param name="isKnown">False if the interval between the samples is too long to determine the motion.</param>
        public void SetTruth(int joint, in TruthSpan span, bool isKnown)
        {
            for (var i = 0; i < _count; i++)
            {
                var index = (_first + i) % Capacity;
                ref var frame = ref _frames[index];
                if (frame.At <= span.Start || frame.At > span.End) continue;
                frame.IsLost |= !isKnown;
                frame.Missing--;
                ref var values = ref _joints[index * _jointCount + joint];
                values.Truth = span.At(frame.At, out values.Uncertainty);
            }
        }

        /// <summary>Removes and returns the oldest frame whose motion is known, if the true positions of all its needed joints are set.</summary>
        /// <param name="joints">Receives the values of the joints; its length is the number of joints.</param>
        public bool TryTakeFirst(out Frame frame, Span<JointValues> joints)
        {
            while (_count > 0 && _frames[_first].Missing == 0)
            {
                frame = _frames[_first];
                _joints.AsSpan(_first * _jointCount, _jointCount).CopyTo(joints);
                RemoveFirst();
                if (!frame.IsLost) return true;
            }
            frame = default;
            return false;
        }

        public void Clear() => _first = _count = 0;

        void RemoveFirst()
        {
            _first = (_first + 1) % Capacity;
            _count--;
        }

        public struct Frame
        {
            public ControlTime At;
            public PoseState State;
            public int Missing;
            public bool IsLost, IsToolKnown;
            public double ClockError;
            public double X, Y, Z, HeldX, HeldY, HeldZ;
        }

        public struct JointValues
        {
            public double Displayed, Held, Truth, Uncertainty;
        }
    }
}
