using System;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Fitting
{
    /// <summary>The newest poses of one marker, with when they were seen.</summary>
    sealed class PoseWindow
    {
        /// <summary>Eight seconds of a camera's rate: more does not make a mean much better.</summary>
        public const int Capacity = 256;

        readonly RigidTransform[] _poses = new RigidTransform[Capacity];
        readonly HeadsetTime[] _times = new HeadsetTime[Capacity];
        int _next;

        public int Count { get; private set; }

        /// <summary>When the newest was seen; only where there is one.</summary>
        public HeadsetTime Newest => TimeOf(0);

        public void Add(in RigidTransform pose, HeadsetTime seen)
        {
            _poses[_next] = pose;
            _times[_next] = seen;
            _next = (_next + 1) % Capacity;
            if (Count < Capacity) Count++;
        }

        public void Clear() => Count = 0;

        /// <param name="back">0 for the newest, 1 for the one before, …</param>
        public ref readonly RigidTransform PoseOf(int back) => ref _poses[(_next - 1 - back + Capacity) % Capacity];

        /// <param name="back">0 for the newest, 1 for the one before, …</param>
        public HeadsetTime TimeOf(int back) => _times[(_next - 1 - back + Capacity) % Capacity];

        /// <summary>How many of the newest it takes to go back that far; 0 where they do not reach.</summary>
        public int CountOver(TimeSpan span)
        {
            for (var back = 1; back < Count; back++)
                if (Newest - TimeOf(back) >= span) return back + 1;
            return 0;
        }

        /// <summary>How many of the newest were seen since.</summary>
        public int CountSince(HeadsetTime time)
        {
            var count = 0;
            while (count < Count && TimeOf(count) >= time) count++;
            return count;
        }
    }
}
