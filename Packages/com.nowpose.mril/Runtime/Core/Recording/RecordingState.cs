namespace Nowpose.Recording
{
    /// <summary>State of a recording. It never returns to <see cref="Recording"/>.</summary>
    public enum RecordingState
    {
        Recording,

        /// <summary>Ended by disposal; the file is complete.</summary>
        Closed,

        /// <summary>Ended at the maximum size; the file is complete up to there.</summary>
        Full,

        /// <summary>Ended because the file cannot be written (no permission, disk full, device removed); the written part remains.</summary>
        Failed,
    }
}
