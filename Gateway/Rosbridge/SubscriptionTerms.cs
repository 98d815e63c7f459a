using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>How a client wants a topic.</summary>
/// <param name="ThrottleMs">Shortest time between two messages; 0 for all.</param>
/// <param name="QueueLength">Messages that may wait; 0 leaves it to the gateway.</param>
readonly record struct SubscriptionTerms(RosTimeForm Form, int ThrottleMs, int QueueLength)
{
    public static SubscriptionTerms Of(RosbridgeMessage message) =>
        new(RosTopics.TimeFormOf(message.Type), message.ThrottleRateMs, message.QueueLength);

    /// <summary>One stream for both of a client's subscriptions to a topic, as rosbridge does it: the faster, the shorter.</summary>
    public SubscriptionTerms With(SubscriptionTerms other) =>
        new(Form, Math.Min(ThrottleMs, other.ThrottleMs), Shorter(QueueLength, other.QueueLength));

    static int Shorter(int a, int b) => a == 0 || b == 0 ? Math.Max(a, b) : Math.Min(a, b);
}
