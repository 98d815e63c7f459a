using System.Text.Json;
using Nowpose.Network;
using Nowpose.Protocol;

namespace Nowpose.Cli.Headset;

/// <summary>Gets the namespaces of the robots that a gateway serves, for messages about a robot that was not found.</summary>
static class ServedNamespaces
{
    const string CallId = "nowpose namespaces";

    static readonly TimeSpan Timeout = TimeSpan.FromSeconds(3);

    /// <summary>Gets the namespaces in alphabetical order; none if the gateway does not list its topics within a few seconds.</summary>
    public static async Task<IReadOnlyList<string>> ReadAsync(ConnectionSettings connection, IHeadsetClock clock, CancellationToken cancel)
    {
        IReadOnlyList<string> found = [];
        using var end = CancellationTokenSource.CreateLinkedTokenSource(cancel);
        end.CancelAfter(Timeout);
        using var link = WebSocketLinks.Create(connection, clock);
        try
        {
            await link.OpenAsync(end.Token);
            await link.SendAsync(RosbridgeWriter.CallService(RosTopics.GetTopics, CallId), end.Token);
            await link.ReceiveAsync(Take, end.Token);
        }
        catch (Exception)
        {
            // Ends here after the response, too. A failed connection is reported by the caller, which has a connection of its own.
        }

        return found;

        void Take(ReceivedText received)
        {
            if (received.Dropped != DropReason.None) return;
            using var message = JsonDocument.Parse(received.Utf8);
            if (!message.RootElement.TryGetProperty("id", out var id) || id.GetString() != CallId) return;
            found = NamespacesIn(message.RootElement.GetProperty("values").GetProperty("topics"));
            end.Cancel();
        }
    }

    static string[] NamespacesIn(JsonElement topics) =>
    [
        .. topics.EnumerateArray().Select(topic => RobotTopic.Parse(topic.GetString()).Robot).Where(robot => robot.Length > 0)
            .Distinct().Order(StringComparer.Ordinal),
    ];
}
