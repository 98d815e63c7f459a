using Nowpose.Protocol;

namespace Nowpose.Gateway.Hub;

/// <summary>The reason why the hub refused a message.</summary>
/// <param name="What">The joint, frame, signal or robot for which the message was refused.</param>
/// <param name="Owner">The source that owns the joint, frame or signal; null if the reason is not another source.</param>
readonly record struct Refusal(DropReason Reason, string What, HubSource Owner = null);

/// <summary>A transform or a signal that the hub left out of a published message, because it breaks a limit of the cell.</summary>
/// <param name="What">The frame with its parent, or the signal.</param>
readonly record struct LeftOut(DropReason Reason, string What);
