namespace Nowpose.Gateway.Hub;

/// <summary>The reason why the hub refused a message or a part of it.</summary>
/// <param name="What">The joint, frame, signal or robot for which the message was refused.</param>
/// <param name="Owner">The source that owns the joint, frame or signal; null if the reason is not another source.</param>
/// <param name="Rule">The fault as one clause; null for the text of the reason.</param>
/// <param name="LeftOut">Number of joints that were left out of the published message; 0 if the whole message was refused.</param>
readonly record struct Refusal(DropReason Reason, string What, HubSource Owner = null, string Rule = null, int LeftOut = 0)
{
    /// <summary>Whether the other joints of the message were published.</summary>
    public bool IsPartial => LeftOut > 0;
}

/// <summary>
/// A transform or a signal that was left out of a published message: its content is invalid, it breaks a limit of the cell, or it belongs to another source.
/// </summary>
/// <param name="Name">The frame or the signal; empty if its name cannot be read.</param>
/// <param name="Fault">The frame or signal and its fault as one clause.</param>
/// <param name="Owner">The source that owns the frame or signal; null if the reason is not another source.</param>
readonly record struct LeftOut(DropReason Reason, string Name, string Fault, HubSource Owner = null);
