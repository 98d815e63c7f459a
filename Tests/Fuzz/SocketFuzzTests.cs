using System.Net.WebSockets;
using System.Text;
using Nowpose.Gateway;
using Nowpose.Gateway.Plants;
using Nowpose.Headless.Tests.Autobahn;
using Nowpose.Headless.Tests.Gateway;
using Nowpose.Headless.Tests.Network;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Fuzz;

/// <summary>Sends tens of thousands of malformed inputs over real sockets to a running gateway, and from a malicious server to a headset.</summary>
[NonParallelizable] // measures the memory of the whole process
public class SocketFuzzTests
{
    const int Seed = 11;
    const int Messages = 20_000, FrameConnections = 250, FramesEach = 20, SyncConnections = 1000, ServerMessages = 10_000;
    const string Last = "after the damaged ones";
    const long MaxGrowthBytes = 16 * 1024 * 1024;

    [Test]
    public async Task Gateway_DamagedMessages_StillAnswersAValidMessage()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { SourceMessagesPerSecond = 100_000 });
        await SendSpoiltAsync(gateway, Seed, Messages / 10);
        var before = GC.GetTotalMemory(forceFullCollection: true);

        await SendSpoiltAsync(gateway, Seed + 1, Messages);

        Assert.That(GC.GetTotalMemory(forceFullCollection: true) - before, Is.LessThan(MaxGrowthBytes), $"bytes not freed, seed {Seed}");
    }

    [Test]
    public async Task Gateway_DamagedFrames_StillServesAValidClient()
    {
        await using var gateway = await Gateways.StartAsync();
        var random = new Random(Seed);

        for (var i = 0; i < FrameConnections; i++)
        {
            using var raw = await RawWebSocket.OpenAsync(gateway);
            var script = new CaseScript(true, "{\"op\":\"call_service\",\"service\":\"/rosapi/get_time\",\"id\":\"", "\"}");
            for (var n = 0; n < FramesEach; n++) Spoil(script, random);
            await new FramedPeer(raw.Stream, isMasked: true).SendAsync(script);
            // Ends the connection, because the last frame may be incomplete. Any other malformed frame has already ended the connection.
            raw.EndSending();
            await raw.ExpectEndAsync();
        }

        await Soon.BecomesAsync(() => gateway.WebSocketConnections.Open == 0, $"none of them stays, seed {Seed}");
        var refused = gateway.WebSocketConnections[Closure.MalformedFrame];
        TestContext.Out.WriteLine($"{refused} of {FrameConnections} connections ended for their frames");
        Assert.That(refused, Is.GreaterThan(FrameConnections * 9 / 10), $"seed {Seed}");
        await HonestAsync(gateway);
    }

    [Test]
    public async Task SyncServer_DamagedFrames_StillAnswersAValidFrame()
    {
        await using var gateway = await Gateways.StartAsync();
        var random = new Random(Seed);

        for (var i = 0; i < SyncConnections; i++)
        {
            using var client = await RawSyncClient.ConnectAsync(gateway);
            try
            {
                for (var n = random.Next(1, 20); n > 0; n--) await client.SendAsync(FrameMutator.Next(random));
            }
            catch (IOException)
            {
                // The gateway has already closed the connection, which is correct.
            }
            client.EndSending();
            await client.ExpectEndAsync();
        }

        await Soon.BecomesAsync(() => gateway.SyncConnections.Open == 0, $"none of them stays, seed {Seed}");
        var refused = gateway.SyncConnections[Closure.MalformedFrame];
        TestContext.Out.WriteLine($"{refused} of {SyncConnections} connections ended for their frames");
        Assert.That(refused, Is.GreaterThan(SyncConnections * 9 / 10), $"seed {Seed}");
        using var honest = await RawSyncClient.ConnectAsync(gateway);
        var reply = await honest.ExchangeAsync(SyncFrame.Request(7, 42));
        Assert.That(reply?.Sequence, Is.EqualTo(7u), $"seed {Seed}");
    }

    [Test]
    public async Task Headset_MaliciousServer_ShowsFinitePosesAndStillAcceptsAValidMessage()
    {
        using var server = new FakeWebSocketServer();
        using var sync = new FakeSyncServer(new WildReplies(Seed).Answer);
        var clock = new StopwatchHeadsetClock();
        using var session = new CompensationSession(
            new SessionSettings(
                new ConnectionSettings("127.0.0.1", sync.Port, server.Port), new VisualisationLatency(TimeSpan.FromMilliseconds(40)),
                    syncIntervalMs: 20),
            RobotFiles.Load("youbot"), clock);
        session.Connect();
        var socket = await server.AcceptAsync();
        var (random, mutator) = (new Random(Seed), new TextMutator(Seeds.Messages));

        for (var i = 0; i < ServerMessages; i++)
        {
            await socket.SendAsync(Encoding.UTF8.GetBytes(mutator.Next(random)), WebSocketMessageType.Text, true, CancellationToken.None).Bounded();
            if (i % 20 == 0) Show(session, clock);
        }
        await socket.SendAsync(
            Encoding.UTF8.GetBytes(RosbridgeWriter.Publish(RosTopics.RobotDescription, new StringMessage(RobotFiles.LoadText("youbot")))),
                WebSocketMessageType.Text, true,
            CancellationToken.None).Bounded();

        await Soon.BecomesAsync(() => { Show(session, clock); return session.RobotDescription == RobotFiles.LoadText("youbot"); },
            $"the valid description, seed {Seed}");
        Assert.That(session.Statistics(clock.Now).Samples, Is.GreaterThan(0), "some samples were accepted");
    }

    static void Show(CompensationSession session, IHeadsetClock clock)
    {
        foreach (var joint in session.Tick(clock.Now).Joints.ToArray()) Assert.That(double.IsFinite(joint), Is.True, $"{joint}, seed {Seed}");
        Assert.That(session.Statistics(clock.Now).Clock.ErrorBound, Is.GreaterThanOrEqualTo(TimeSpan.Zero));
    }

    static async Task SendSpoiltAsync(GatewayServer gateway, int seed, int messages)
    {
        var (random, mutator) = (new Random(seed), new TextMutator(Seeds.Messages));
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        var reading = ReadUntilAsync(client, Last);
        for (var i = 0; i < messages; i++) await client.SendAsync(mutator.Next(random));
        // A response on the same connection shows that all earlier messages were read and that none of them ended the connection.
        await client.SendAsync(RosbridgeWriter.CallService(RosTopics.GetTime, Last));
        await reading;
        await HonestAsync(gateway);
    }

    static async Task ReadUntilAsync(RawRosbridgeClient client, string words)
    {
        while (!(await client.ReceiveTextAsync()).Contains(words))
        {
        }
    }

    static async Task HonestAsync(GatewayServer gateway)
    {
        using var honest = await RawRosbridgeClient.ConnectAsync(gateway);
        await honest.RoundTripAsync();
    }

    static void Spoil(CaseScript script, Random random)
    {
        script.Chop = random.Next(4) == 0 ? random.Next(1, 20) : 0;
        var opcode = random.Next(3) == 0 ? random.Next(16) : CaseScript.Text;
        script.Frame(opcode, script.Message("x", random.Next(100)), random.Next(5) != 0, random.Next(10) == 0 ? random.Next(8) : 0);
        if (random.Next(10) != 0 || script.Chunks.Count == 0) return;
        var chunk = script.Chunks[^1];
        chunk[random.Next(chunk.Length)] ^= (byte)(1 << random.Next(8));
    }
}
