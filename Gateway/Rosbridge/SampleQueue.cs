using System.Diagnostics;
using System.Threading.Channels;
using Nowpose.Gateway.Hub;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>
/// The queue of a subscription to a topic that is not latched per name. Drops samples that have waited too long for a slow reader.
/// </summary>
/// <param name="lost">Called for each message that is not sent.</param>
sealed class SampleQueue(Channel<HubMessage> queue, Action lost)
{
    /// <summary>Maximum time for which a sample waits for a slow reader. An older sample is dropped if a newer one is queued.</summary>
    static readonly TimeSpan MaxSampleAge = TimeSpan.FromMilliseconds(150);

    /// <summary>Returns whether a message has waited too long for the client.</summary>
    /// <param name="receivedAt">Time at which the message was received, a count of <see cref="Stopwatch"/>.</param>
    /// <param name="waitedUntil">Time at which the last wait of a message for the client ended, a count of <see cref="Stopwatch"/>.</param>
    public static bool IsOld(long receivedAt, long waitedUntil) => receivedAt < waitedUntil && Stopwatch.GetElapsedTime(receivedAt) > MaxSampleAge;

    /// <summary>Removes and returns the next message; null if there is none. Not thread-safe.</summary>
    /// <inheritdoc cref="IsOld" path="/param[@name='waitedUntil']"/>
    public HubMessage Next(long waitedUntil)
    {
        while (queue.Reader.TryRead(out var message))
        {
            // Drops only messages that waited for the client. A message that waited for another reason, such as a busy processor, is sent late.
            var isSample = message.Content is JointStateMessage or TransformsMessage;
            if (!isSample || !IsOld(message.ReceivedAt, waitedUntil) || !queue.Reader.TryPeek(out _)) return message;
            lost();
        }

        return null;
    }
}
