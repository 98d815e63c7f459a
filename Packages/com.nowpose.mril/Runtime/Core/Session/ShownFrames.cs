using System;
using Nowpose.Kinematics;

namespace Nowpose.Session
{
    /// <summary>Frames that were shown and wait for the samples which tell where the robot truly was. Allocates nothing once made.</summary>
    sealed class ShownFrames
    {
        /// <summary>More than four seconds at 120 frames a second; beyond, the oldest go unjudged.</summary>
        const int Capacity = 512;

        readonly int _jointCount;
        readonly Frame[] _frames = new Frame[Capacity];
        readonly double[] _truths;
        int _first, _count;

        /// <param name="jointCount">So many joints have to tell the truth about each frame.</param>
        public ShownFrames(int jointCount)
        {
            _jointCount = jointCount;
            _truths = new double[Capacity * jointCount];
        }

        /// <param name="displayed">The tool's pose as displayed.</param>
        /// <param name="held">The tool's pose by the newest samples alone.</param>
        public void Add(ControlTime at, in RigidTransform displayed, in RigidTransform held)
        {
            if (_count == Capacity) RemoveFirst();
            _frames[(_first + _count++) % Capacity] = new Frame
            {
                At = at, Missing = _jointCount,
                X = displayed.X, Y = displayed.Y, Z = displayed.Z, HeldX = held.X, HeldY = held.Y, HeldZ = held.Z,
            };
        }

        /// <summary>A joint moved from one sample to the next: the truth about it for the frames between, taken on the straight line.</summary>
        /// <param name="isKnown">False when the way between the samples is too long to know anything.</param>
        public void Tell(int joint, ControlTime start, double startPosition, ControlTime end, double endPosition, bool isKnown)
        {
            var length = (double)(end - start).Ticks;
            for (var i = 0; i < _count; i++)
            {
                var index = (_first + i) % Capacity;
                ref var frame = ref _frames[index];
                if (frame.At <= start || frame.At > end) continue;
                frame.IsLost |= !isKnown;
                frame.Missing--;
                _truths[index * _jointCount + joint] = startPosition + (endPosition - startPosition) * ((frame.At - start).Ticks / length);
            }
        }

        /// <summary>The oldest frame that waits, if all joints have told the truth about it; it waits no longer.</summary>
        /// <param name="truth">One position per joint.</param>
        public bool TryTakeFirst(out Frame frame, Span<double> truth)
        {
            while (_count > 0 && _frames[_first].Missing == 0)
            {
                frame = _frames[_first];
                _truths.AsSpan(_first * _jointCount, _jointCount).CopyTo(truth);
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
            public int Missing;
            public bool IsLost;
            public double X, Y, Z, HeldX, HeldY, HeldZ;
        }
    }
}
