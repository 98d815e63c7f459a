using Nowpose.Frames;
using Nowpose.Latency;

namespace Nowpose.Session
{
    /// <summary>Determines the state of a displayed pose: whether the pose is current and, if not, the most severe reason.</summary>
    static class PoseStateRule
    {
        /// <summary>Returns the state of a pose at a display time.</summary>
        /// <param name="isIncomplete">Whether a part of the pose is unknown.</param>
        /// <param name="isHeld">Whether a part of the pose is not predicted to the display time.</param>
        public static PoseState Of(in DisplayMoment moment, bool isIncomplete, bool isHeld)
        {
            if (isIncomplete) return PoseState.Incomplete;
            if (!moment.IsTrusted) return PoseState.Unsynchronised;
            if (isHeld) return PoseState.Held;
            return moment.Range == RangeState.Outside ? PoseState.OutsideRange : PoseState.Current;
        }

        /// <summary>Returns the state of a frame's displayed pose.</summary>
        /// <param name="frame">The frame; null if no pose of the frame has been received.</param>
        public static PoseState Of(in DisplayMoment moment, CellFrame frame)
        {
            if (frame == null || frame.State == FrameState.Missing || frame.State == FrameState.Orphan) return PoseState.Incomplete;
            if (frame.IsFixed && frame.State == FrameState.Current) return PoseState.Current;
            return Of(moment, isIncomplete: false, isHeld: frame.State != FrameState.Current);
        }
    }
}
