namespace Nowpose.Recording
{
    /// <summary>What one line of a session file tells.</summary>
    enum RecordKind
    {
        /// <summary>A sync exchange with its verdict.</summary>
        Sync,

        /// <summary>A message with joint positions, as received.</summary>
        Sample,

        /// <summary>A message of set-points, as received.</summary>
        Plan,

        /// <summary>What one frame displayed.</summary>
        Frame,

        /// <summary>The clock model has another state, has stepped, or has become known.</summary>
        Clock,

        /// <summary>L_visu, the state of the constant-latency range or the reprojection mode has changed.</summary>
        Display,

        /// <summary>How the session does: once a second.</summary>
        Statistics,

        /// <summary>What was dropped by reason: once a second while it changes.</summary>
        Drops,

        /// <summary>What a headset or an adapter says of itself. In a gateway's file only.</summary>
        Diagnostics,
    }
}
