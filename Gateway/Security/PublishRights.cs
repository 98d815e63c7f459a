using Nowpose.Gateway.Rosbridge;
using Nowpose.Gateway.Status;

namespace Nowpose.Gateway.Security;

/// <summary>Decides what a client may publish.</summary>
sealed class PublishRights(Role role)
{
    /// <summary>Whether clients can publish on the topic. Only the gateway can publish its version and the status of joints and signals.</summary>
    public static bool IsOpen(RobotTopic topic) =>
        Publications.IsKnown(topic) && topic.Kind is not (RosTopics.JointStatus or RosTopics.SignalStatus or RosTopics.Version);

    /// <summary>Whether the client may offer the time of a plant.</summary>
    public bool MayOfferTime => role == Role.Source;

    /// <summary>Returns the reason why the client may not publish on a topic; <see cref="DropReason.None"/> if it may.</summary>
    public DropReason On(RobotTopic topic)
    {
        if (!IsOpen(topic))
            return role == Role.Source ? DropReason.UnknownTopic : DropReason.NotAllowed;
        return role == Role.Source || IsOfItself(topic) ? DropReason.None : DropReason.NotAllowed;
    }

    /// <summary>Whether the client may use a name in its messages. Only a source may use the name of an adapter.</summary>
    public bool MayUse(string name) => role == Role.Source || !StatusObjects.IsAdapter(name);

    // Whether messages on the topic describe only their sender, so that every client may publish on it.
    static bool IsOfItself(RobotTopic topic) => topic.Kind is RosTopics.Diagnostics or RosTopics.Displayed;
}
