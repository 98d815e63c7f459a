using System.Net.WebSockets;
using System.Text;
using System.Text.Json;
using NUnit.Framework;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Recording;

/// <summary>Tests that a gateway exits normally and loses no message when a service manager stops it while messages arrive.</summary>
[Platform(Exclude = "Win")]
public class GracefulEndTests
{
    string _folder;

    [SetUp]
    public void SetUp() => _folder = Directory.CreateTempSubdirectory("nowpose-recordings-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    [TestCase("TERM", 0)]
    [TestCase("HUP", 0)]
    [TestCase("INT", 130)]
    public async Task TerminationSignal_DuringTraffic_EndsGracefullyWithAllForwardedMessagesInTheFile(string signal, int status)
    {
        using var gateway = new PeerProcess(
            "Nowpose.Gateway.dll", "serve", "--sync-port", "0", "--ws-port", "0", "--recordings", _folder, "--record");
        await Soon.BecomesAsync(() => gateway.Printed("state serving"), "the gateway is up");
        var uri = new Uri(gateway.Lines.Single(line => line.StartsWith("websocket ", StringComparison.Ordinal)).Split(' ')[1]);
        using var client = new ClientWebSocket();
        await client.ConnectAsync(uri, default).Bounded();
        await SendAsync(client, """{"op":"subscribe","topic":"/joint_states","queue_length":1000}""");
        var seen = new List<int>();
        var reading = ReadAsync(client, seen);
        using var enough = new CancellationTokenSource();
        var writing = WriteAsync(client, enough.Token);
        await Soon.BecomesAsync(() => { lock (seen) return seen.Count > 200; }, "the client receives messages");

        var ended = await gateway.SignalAsync(signal).Bounded();

        await enough.CancelAsync();
        await writing.Bounded();
        await reading.Bounded();
        Assert.That(ended, Is.EqualTo(status), gateway.All);
        var lines = File.ReadAllLines(Directory.GetFiles(_folder).Single()).Select(line => JsonDocument.Parse(line).RootElement).ToArray();
        Assert.That(lines[^1].GetProperty("reason").GetString(), Is.EqualTo("closed"));
        var recorded = lines.Where(line => line.GetProperty("kind").GetString() == "sample")
            .Select(line => (int)line.GetProperty("position")[0].GetDouble()).ToArray();
        Assert.That(recorded, Is.EqualTo(Enumerable.Range(0, recorded.Length)), "no frame is missing in between");
        Assert.That(recorded.Length, Is.GreaterThan(seen.Max()), "the file contains all forwarded messages");
    }

    static Task SendAsync(ClientWebSocket client, string text) =>
        client.SendAsync(Encoding.UTF8.GetBytes(text), WebSocketMessageType.Text, true, default);

    static async Task WriteAsync(ClientWebSocket client, CancellationToken enough)
    {
        try
        {
            for (var i = 0; !enough.IsCancellationRequested; i++)
            {
                await SendAsync(client, Gateways.StateText(i));
                // Sends less than 1000 messages/s: after a pause of seconds the gateway reads all waiting messages at once, and it accepts 4000/s.
                if (i % 20 == 19) await Task.Delay(20, CancellationToken.None);
            }
        }
        catch (WebSocketException)
        {
            // The gateway has ended.
        }
    }

    static async Task ReadAsync(ClientWebSocket client, List<int> seen)
    {
        var buffer = new byte[65536];
        try
        {
            while (true)
            {
                var result = await client.ReceiveAsync(buffer, default);
                if (result.MessageType == WebSocketMessageType.Close) return;
                if (!RosbridgeReader.TryRead(Encoding.UTF8.GetString(buffer, 0, result.Count), out var message, out _) || message.JointState == null) continue;
                lock (seen) seen.Add((int)message.JointState.Positions[0]);
            }
        }
        catch (WebSocketException)
        {
            // The gateway has ended.
        }
    }
}
