using Nowpose.Messages;

namespace Nowpose.Frames
{
    /// <summary>Reason why a frame has no current pose of its own. Keeps the text until the reason changes, because it is read in each display frame.</summary>
    sealed class FrameFault
    {
        (FrameState State, string Of, string Text) _kept;

        /// <summary>Returns the reason, in one line; null if the frame's pose is current, apart from reasons that affect all frames.</summary>
        /// <param name="frame">The frame; null if no pose of it has been received.</param>
        public string Of(CellFrame frame, FrameTree tree)
        {
            if (frame == null) return FrameMessages.NoPose;
            switch (frame.State)
            {
                case FrameState.Current: return null;
                case FrameState.Missing: return FrameMessages.NoPose;
                case FrameState.Held:
                    return frame.RefusedParent != null ? Kept(frame.State, frame.RefusedParent)
                        : frame.HasStationarySource ? FrameMessages.OlderThanConnection
                        : frame.ReceivesOldPoses ? FrameMessages.PosesTooOld : frame.ReceivesRarePoses ? FrameMessages.PosesTooRare : FrameMessages.PosesStopped;
                case FrameState.GripUnknown: return Kept(frame.State, frame.GripFault);
                default: return Kept(frame.State, tree.ReasonAbove(frame, out _, out _));
            }
        }

        string Kept(FrameState state, string of)
        {
            if (state == _kept.State && of == _kept.Of) return _kept.Text;
            _kept = (state, of, state == FrameState.Held ? FrameMessages.ParentRefused(of)
                : of == FrameMessages.CarrierMoved ? of : state == FrameState.GripUnknown ? FrameMessages.MayBeGripped(of)
                : state == FrameState.Orphan ? FrameMessages.FrameUnknown(of) : FrameMessages.FrameNotCurrent(of));
            return _kept.Text;
        }
    }
}
