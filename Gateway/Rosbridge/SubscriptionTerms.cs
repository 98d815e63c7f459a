namespace Nowpose.Gateway.Rosbridge;

/// <summary>The options of a subscription.</summary>
/// <param name="Form">Format of times.</param>
/// <param name="ThrottleMs">Minimum time between two messages, ms; 0 to get all messages.</param>
/// <param name="QueueLength">Maximum number of queued messages; 0 for the gateway's default.</param>
readonly record struct SubscriptionTerms(RosTimeForm Form, int ThrottleMs, int QueueLength)
{
    public static SubscriptionTerms Of(RosbridgeMessage message) =>
        new(RosTopics.TimeFormOf(message.Type), message.ThrottleRateMs, message.QueueLength);

    /// <summary>
    /// Combines the options of two subscriptions of one client to one topic, as rosbridge does: the higher rate and the shorter queue.
    /// </summary>
    public SubscriptionTerms With(SubscriptionTerms other) =>
        new(Form, Math.Min(ThrottleMs, other.ThrottleMs), Shorter(QueueLength, other.QueueLength));

    static int Shorter(int a, int b) => a == 0 || b == 0 ? Math.Max(a, b) : Math.Min(a, b);
}
