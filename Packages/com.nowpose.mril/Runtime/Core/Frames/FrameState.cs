namespace Nowpose.Frames
{
    /// <summary>Whether a frame is shown where it is now.</summary>
    enum FrameState
    {
        /// <summary>No pose has been received; the displayed pose is a placeholder.</summary>
        Missing,

        /// <summary>The parent is neither the world, nor a link of a known robot, nor a known frame. The pose shown last is kept.</summary>
        Orphan,

        /// <summary>The newest pose is too old to be predicted.</summary>
        Held,

        /// <summary>The frame itself is known, but one above it is not current.</summary>
        ParentNotCurrent,

        /// <summary>The pose is that at the display time.</summary>
        Current,
    }
}
