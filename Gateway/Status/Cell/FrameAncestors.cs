using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Status.Cell;

/// <summary>Finds the faults of a frame that its parents cause. Not thread-safe.</summary>
/// <param name="frames">The listed frames.</param>
/// <param name="isCurrent">Returns whether a frame's own poses are current.</param>
/// <param name="rootOfLink">Returns the root link of the described robot to which a link belongs; null for a frame that is not a link.</param>
/// <param name="isLinkCurrent">Returns whether the joints between a robot's base and a link are current.</param>
sealed class FrameAncestors(
    IReadOnlyDictionary<string, FrameEntry> frames, Predicate<FrameEntry> isCurrent, Func<string, string> rootOfLink, Predicate<string> isLinkCurrent)
{
    /// <summary>
    /// Returns an orphan's state if the parents of a frame reach neither the world nor a robot whose base is not a frame, and otherwise the state of a frame
    /// with a parent that is not current; null if all parents are current. The cause of an orphan is the missing parent, or the orphan above the frame.
    /// </summary>
    public (string State, string Reason, string Cause)? FaultOf(string name, FrameEntry frame)
    {
        var (child, parent) = (name, frame.Parent);
        (string State, string Reason, string Cause)? stale = null;
        // The number of steps is limited, because a frame whose source has ended stays listed, so that the listed parents may form a cycle.
        for (var steps = 0; steps <= frames.Count; steps++)
        {
            if (parent == FrameParents.World) return stale;
            // A link moves with its robot, even if a source publishes its pose.
            var root = rootOfLink?.Invoke(parent);
            if (root != null && !isLinkCurrent(parent)) stale ??= Stale(child, parent);
            var above = Published(root ?? parent);
            if (above == null && root != null) return stale;
            // A tracked frame is removed when its source ends. The base of a robot keeps its last pose.
            if (above == null || above.IsEnded && root == null) break;
            parent = root ?? parent;
            if (!isCurrent(above)) stale ??= Stale(child, parent);
            (child, parent) = (parent, above.Parent);
        }

        return child == name
            ? (CellStates.Orphan, CellReasons.ParentMissing(parent), parent) : (CellStates.Orphan, CellReasons.ParentMissingAbove(child, parent), child);

        (string, string, string) Stale(string below, string above) => (
            CellStates.ParentStale, below == name ? CellReasons.ParentNotCurrent(above) : CellReasons.ParentNotCurrentAbove(above), null);
    }

    FrameEntry Published(string name) => frames.TryGetValue(name, out var frame) && frame.HasAny ? frame : null;
}
