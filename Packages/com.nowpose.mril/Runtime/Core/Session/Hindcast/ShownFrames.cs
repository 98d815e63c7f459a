using System;
using Nowpose.Kinematics;

namespace Nowpose.Session.Hindcast
{
    /// <summary>Frames that were shown and wait for the samples which tell where the robot truly was. Allocates nothing once made.</summary>
    sealed class ShownFrames
    {
        /// <summary>More than four seconds at 120 frames a second; beyond, the oldest go unjudged.</summary>
        const int Capacity = 512;

        readonly int _jointCount;
        readonly Frame[] _frames = new Frame[Capacity];
        readonly JointValues[] _joints;
        int _first, _count;

        /// <param name="jointCount">So many joints have to tell the truth about each frame.</param>
        public ShownFrames(int jointCount)
        {
            _jointCount = jointCount;
            _joints = new JointValues[Capacity * jointCount];
        }

        /// <param name="state">State of the frame's pose.</param>
        /// <param name="displayed">The tool's pose as displayed.</param>
        /// <param name="held">The tool's pose by the newest samples alone.</param>
        /// <param name="clockError">Bound of the clock's error, s.</param>
        /// <returns>Places for the joints' displayed and held positions.</returns>
        public Span<JointValues> Add(ControlTime at, PoseState state, in RigidTransform displayed, in RigidTransform held, double clockError)
        {
            if (_count == Capacity) RemoveFirst();
            var index = (_first + _count++) % Capacity;
            _frames[index] = new Frame
            {
                At = at, State = state, Missing = _jointCount, ClockError = clockError,
                X = displayed.X, Y = displayed.Y, Z = displayed.Z, HeldX = held.X, HeldY = held.Y, HeldZ = held.Z,
            };
            return _joints.AsSpan(index * _jointCount, _jointCount);
        }

        /// <summary>The truth about a joint for the frames within a span.</summary>
        /// <param name="isKnown">False when the way between the samples is too long to know anything.</param>
        public void Tell(int joint, in TruthSpan span, bool isKnown)
        {
            for (var i = 0; i < _count; i++)
            {
                var index = (_first + i) % Capacity;
                ref var frame = ref _frames[index];
                if (frame.At <= span.Start || frame.At > span.End) continue;
                frame.IsLost |= !isKnown;
                frame.Missing--;
                ref var values = ref _joints[index * _jointCount + joint];
                values.Truth = span.At(frame.At, out values.Doubt);
            }
        }

        /// <summary>The oldest frame that waits, if all joints have told the truth about it; it waits no longer.</summary>
        /// <param name="joints">As long as there are joints.</param>
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
            public bool IsLost;
            public double ClockError;
            public double X, Y, Z, HeldX, HeldY, HeldZ;
        }

        public struct JointValues
        {
            public double Displayed, Held, Truth, Doubt;
        }
    }
}
