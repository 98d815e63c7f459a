using System;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Fitting
{
    /// <summary>The newest poses of one marker with their times.</summary>
    sealed class PoseWindow
    {
        /// <summary>Capacity in poses: eight seconds at a typical camera rate. More poses hardly improve a mean.</summary>
        public const int Capacity = 256;

        readonly RigidTransform[] _poses = new RigidTransform[Capacity];
        readonly HeadsetTime[] _times = new HeadsetTime[Capacity];
        int _next;

        public int Count { get; private set; }

        /// <summary>Time of the newest pose; valid only if there is one.</summary>
        public HeadsetTime Newest => TimeOf(0);

        public void Add(in RigidTransform pose, HeadsetTime seen)
        {
            _poses[_next] = pose;
            _times[_next] = seen;
            _next = (_next + 1) % Capacity;
            if (Count < Capacity) Count++;
        }

        public void Clear() => Count = 0;

        /// <param name="back">0 for the newest pose, 1 for the previous pose, and so on.</param>
        public ref readonly RigidTransform PoseOf(int back) => ref _poses[(_next - 1 - back + Capacity) % Capacity];

        /// <param name="back">0 for the newest pose, 1 for the previous pose, and so on.</param>
        public HeadsetTime TimeOf(int back) => _times[(_next - 1 - back + Capacity) % Capacity];

        /// <summary>Returns how many of the newest poses are needed to span at least the given time; 0 if all poses together span less.</summary>
        public int CountOver(TimeSpan span)
        {
            for (var back = 1; back < Count; back++)
                if (Newest - TimeOf(back) >= span) return back + 1;
            return 0;
        }

        /// <summary>Returns the number of poses at or after the given time.</summary>
        public int CountSince(HeadsetTime time)
        {
            var count = 0;
            while (count < Count && TimeOf(count) >= time) count++;
            return count;
        }
    }
}
