namespace Nowpose
{
    /// <summary>How far the headset clock is tied to the control clock.</summary>
    public enum ClockState
    {
        /// <summary>No exchange yet.</summary>
        Unsynchronised,

        /// <summary>An offset is known, but not settled: at the start, after a step or a long silence, and while a step is suspected.</summary>
        Converging,

        /// <summary>Settled, and fed by recent exchanges.</summary>
        Synchronised,

        /// <summary>Was synchronised; no exchange has arrived for a while, so the last line is continued.</summary>
        Holdover,
    }
}
