namespace Nowpose.Recording
{
    /// <summary>Kind of a line of a session file.</summary>
    enum RecordKind
    {
        /// <summary>A sync exchange with its verdict.</summary>
        Sync,

        /// <summary>A further robot of the session. Its samples and plans follow this line.</summary>
        Robot,

        /// <summary>A message with joint positions, as received.</summary>
        Sample,

        /// <summary>A message of set-points, as received.</summary>
        Plan,

        /// <summary>The pose of a frame of the cell, as received.</summary>
        Pose,

        /// <summary>A value of a signal, as received.</summary>
        Signal,

        /// <summary>The joints that one frame displayed.</summary>
        Frame,

        /// <summary>The pose at which one frame displayed an object.</summary>
        Object,

        /// <summary>The clock model has changed its state, has stepped, or has become known.</summary>
        Clock,

        /// <summary>L_visu, the state of the constant-latency range or the reprojection mode has changed.</summary>
        Display,

        /// <summary>Statistics of the session, once a second.</summary>
        Statistics,

        /// <summary>Drops by reason, once a second if they have changed.</summary>
        Drops,

        /// <summary>Diagnostics of a headset or an adapter. Only in a gateway's file.</summary>
        Diagnostics,
    }
}
