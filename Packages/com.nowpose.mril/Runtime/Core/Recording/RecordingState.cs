namespace Nowpose.Recording
{
    /// <summary>Where a recording stands. After <see cref="Recording"/> it never comes back to it.</summary>
    public enum RecordingState
    {
        Recording,

        /// <summary>Ended when it was disposed of; the file is whole.</summary>
        Closed,

        /// <summary>Ended at its greatest size; the file is whole up to there.</summary>
        Full,

        /// <summary>Ended because the file cannot be written (no permission, disk full, device gone); what was written stays.</summary>
        Failed,
    }
}
