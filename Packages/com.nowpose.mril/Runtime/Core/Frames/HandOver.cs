using Nowpose.Prediction.Samples;
using Nowpose.Protocol.Cell;

namespace Nowpose.Frames
{
    /// <summary>The hand-over of a frame to a new parent: the poses in the new parent, which wait for the next display frame.</summary>
    sealed class HandOver
    {
        /// <summary>Maximum number of waiting poses. When the maximum is reached, a further pose replaces the newest one.</summary>
        const int MaxWaiting = 8;

        /// <summary>
        /// Number of consecutive poses in another parent, each newer than the previous one, that proves that the clock of the source went back if the last
        /// of them is late by more than <see cref="ArrivalLimits.MaxDelay"/>.
        /// </summary>
        const int MinFarBehind = 2;

        readonly FrameTransform[] _waiting = new FrameTransform[MaxWaiting];
        ControlTime _refused;
        int _refusedCount;

        /// <summary>Number of waiting poses.</summary>
        public int Count { get; private set; }

        public FrameTransform this[int index] => _waiting[index];

        /// <summary>Whether the waiting poses come from /tf_static.</summary>
        public bool IsStationary { get; private set; }

        /// <summary>
        /// Returns whether a pose in another parent is older than the newest pose, or than the waiting poses in a third parent. Returns false if this
        /// pose and the refused poses before it prove that the clock of the source went back.
        /// </summary>
        /// <param name="parent">Present parent of the frame.</param>
        /// <param name="newest">Stamp of the newest pose in the present parent; null if there is none.</param>
        public bool IsOvertaken(in FrameTransform pose, string parent, ControlTime? newest)
        {
            if (Count > 0 && !IsStationary) (parent, newest) = (_waiting[0].Parent, _waiting[Count - 1].Stamp);
            if (pose.Parent == parent || !(pose.Stamp <= newest)) return false;
            return RefusedCount(pose.Stamp) < MinFarBehind || !ArrivalLimits.IsFarBehind(pose.Stamp, newest.Value);
        }

        /// <summary>Records a received pose that is not used because it is overtaken.</summary>
        public void Refuse(in FrameTransform pose) => (_refusedCount, _refused) = (RefusedCount(pose.Stamp), pose.Stamp);

        /// <summary>Ends the series of refused poses, because a pose was used.</summary>
        public void EndRefusals() => _refusedCount = 0;

        /// <summary>Adds a pose. Discards the waiting poses in a third parent.</summary>
        public void Add(in FrameTransform pose, bool isStationary)
        {
            if (Count > 0 && (_waiting[0].Parent != pose.Parent || IsStationary != isStationary)) Count = 0;
            if (Count == MaxWaiting) Count--;
            _waiting[Count++] = pose;
            IsStationary = isStationary;
        }

        /// <summary>Ends the hand-over. No pose waits any longer.</summary>
        public void End() => Count = 0;

        /// <summary>Discards poses whose times are no longer valid.</summary>
        public void Reset()
        {
            EndRefusals();
            // A stationary pose has no time, and is sent only once.
            if (!IsStationary) Count = 0;
        }

        // Number of consecutive refused poses, each newer than the previous one, if a pose with this stamp is the next.
        int RefusedCount(ControlTime stamp) => _refusedCount == 0 || stamp < _refused ? 1 : stamp > _refused ? _refusedCount + 1 : _refusedCount;
    }
}
