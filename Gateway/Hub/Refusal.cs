using Nowpose.Protocol;

namespace Nowpose.Gateway.Hub;

/// <summary>Why the hub refused a message.</summary>
/// <param name="What">The joint, frame, signal or robot that it concerns.</param>
/// <param name="Owner">The source that publishes it; null if it is not about another source.</param>
readonly record struct Refusal(DropReason Reason, string What, HubSource Owner = null);

/// <summary>A transform or a signal that was left out of a published message, because it breaks a limit of the cell.</summary>
/// <param name="What">The frame with its parent, or the signal.</param>
readonly record struct LeftOut(DropReason Reason, string What);
