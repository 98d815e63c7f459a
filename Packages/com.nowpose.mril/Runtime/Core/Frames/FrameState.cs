namespace Nowpose.Frames
{
    /// <summary>State of a frame's displayed pose.</summary>
    enum FrameState
    {
        /// <summary>No pose has been received; the displayed pose is a placeholder.</summary>
        Missing,

        /// <summary>
        /// The parent, or a frame above it, is neither the world, nor a link of a known robot, nor a known frame. The last displayed pose is kept.
        /// </summary>
        Orphan,

        /// <summary>The newest pose is too old to be predicted.</summary>
        Held,

        /// <summary>
        /// The pose would be valid, but it is unknown what a gripper holds or held that may hold the object or may have moved it, see
        /// <see cref="CellFrame.UnknownGrip"/> and <see cref="CellFrame.UnknownMover"/>, or whether the object has moved with its parent since a
        /// gripper released it.
        /// </summary>
        GripUnknown,

        /// <summary>The pose relative to the parent is valid for the display time, but the pose of the parent is not current.</summary>
        ParentNotCurrent,

        /// <summary>The displayed pose is valid for the display time.</summary>
        Current,
    }
}
