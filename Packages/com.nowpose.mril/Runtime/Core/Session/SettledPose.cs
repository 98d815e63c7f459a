using System;

namespace Nowpose.Session
{
    /// <summary>
    /// The state that a display shows for a pose: the most severe state of the last half second. A pose whose state alternates therefore does not
    /// flash, and looks current only after it has been current for half a second.
    /// </summary>
    /// <remarks>
    /// Until the pose is current for the first time, each state is shown only while it lasts, so that a new session looks current at once. The same
    /// applies to <see cref="PoseState.Incomplete"/>, because the pose is not drawn then. Allocates nothing; single-threaded.
    /// </remarks>
    sealed class SettledPose
    {
        readonly HeadsetTime?[] _last = new HeadsetTime?[(int)PoseState.Current];
        HeadsetTime _now;
        bool _isCurrent, _hasBeenCurrent;

        /// <summary>Adds the state of a frame.</summary>
        /// <param name="at">Start of the frame, not earlier than that of the previous frame.</param>
        public void Add(HeadsetTime at, PoseState state)
        {
            // A frame may get the worse state of a moving base after that of its joints.
            if (at > _now) _hasBeenCurrent |= _isCurrent;
            (_now, _isCurrent) = (at, state == PoseState.Current);
            if (!_isCurrent && _hasBeenCurrent) _last[(int)state] = at;
        }

        /// <summary>Returns the state to show for a pose whose state in the newest frame is given.</summary>
        public PoseState Over(PoseState state)
        {
            for (var worse = PoseState.Unsynchronised; worse < state; worse++)
                if (_now - _last[(int)worse] < SessionWatch.Settle) return worse;
            return state;
        }
    }
}
