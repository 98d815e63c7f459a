namespace Nowpose.Gateway.Messages;

/// <summary>Reasons for the state of a frame or a signal.</summary>
static class CellReasons
{
    public const string PosesStopped = "its poses stopped arriving";
    public const string StampsStopped = "its poses arrive with an unchanged time stamp; set each stamp to the control time of its pose";

    public const string StampsOld =
        "its poses arrive with time stamps that are more than 10 s old; compare the clock of its source with the control clock";

    public const string NoPoseAtRest = "its adapter reports it at rest, but no pose has arrived at the gateway";

    public static string StampAhead(double seconds) =>
        FormattableString.Invariant($"its time stamp is {seconds:0} s ahead of the control clock, which was set back or replaced; send it again");

    public const string AdapterSilent = "its adapter has stopped reporting";

    public static string ParentMissing(string parent) =>
        $"no source publishes its parent {parent}, and no described robot has a link of this name";

    /// <param name="frame">The frame whose parent is missing.</param>
    public static string ParentMissingAbove(string frame, string parent) =>
        $"its parents end at frame {frame}: no source publishes the parent {parent} of this frame, and no described robot has a link of this name";

    public static string ParentNotCurrent(string parent) => $"its parent {parent} is not current";

    /// <param name="above">A parent of the frame's parent.</param>
    public static string ParentNotCurrentAbove(string above) => $"frame {above}, on which its parent depends, is not current";
}
