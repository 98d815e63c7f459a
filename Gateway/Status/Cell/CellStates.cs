namespace Nowpose.Gateway.Status.Cell;

/// <summary>Names of the states of frames and signals.</summary>
static class CellStates
{
    /// <summary>State of a tracked frame or a signal with current data.</summary>
    public const string Live = "live";

    /// <summary>State of a frame on /tf_static.</summary>
    public const string Stationary = "stationary";

    /// <summary>State of a tracked frame whose poses have stopped, or of a signal whose adapter has stopped reporting.</summary>
    public const string Stale = "stale";

    /// <summary>State of a frame whose chain of parents reaches neither the world nor a link of a described robot.</summary>
    public const string Orphan = "orphan";

    /// <summary>State of a frame whose own poses are current, but one of its parents is not.</summary>
    public const string ParentStale = "parent-stale";

    /// <summary>State of a signal whose source has ended.</summary>
    public const string Ended = "ended";

    static readonly string[] OfReports = [.. new[] { JointDataState.Refused, JointDataState.Fault, JointDataState.Missing }.Select(JointDataStates.Of)];

    /// <summary>All states of frames and of signals.</summary>
    public static readonly IReadOnlyList<string> OfFrames = [Live, Stationary, Stale, Orphan, ParentStale, .. OfReports], OfSignals = [Live, Stale, Ended, .. OfReports];
}
