using System.Net.Sockets;
using System.Net.WebSockets;
using System.Text.Json;
using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status.Faults;

/// <summary>Tests how the event list reports clients that the gateway refuses: a second client with a used name, and connections beyond the limit.</summary>
public class ClientFaultTests
{
    MonitoredGateway _gateway;

    [SetUp]
    public void SetUp() => _gateway = new MonitoredGateway();

    [TearDown]
    public Task Close() => _gateway.DisposeAsync().AsTask();

    [TestCase("plant/press", "adapter", "press")]
    [TestCase("HoloLens", "headset", "HoloLens")]
    public async Task Name_UsedByTwoClients_IsAnEventWhileTheSecondIsRefused(string hardwareId, string kind, string name)
    {
        await _gateway.StartAsync();
        using var first = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        using var second = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        for (var i = 0; i < 6; i++)
        {
            await ReportAsync(first, hardwareId);
            await first.RoundTripAsync();
            await ReportAsync(second, hardwareId);
            await second.ExpectErrorAsync(nameof(DropReason.JointTaken));
            _gateway.Time.Advance(TimeSpan.FromSeconds(1));
        }

        await _gateway.BeginsAsync(kind, name);
        var refused = await _gateway.EventAsync(kind, name);
        Assert.That(refused.GetProperty("text").GetString(), Does.Contain("rosbridge 127.0.0.1").And.Contains("name"));

        for (var i = 0; i < 6; i++)
        {
            await ReportAsync(first, hardwareId);
            await first.RoundTripAsync();
            _gateway.Time.Advance(TimeSpan.FromSeconds(1));
        }

        await _gateway.EndsAsync(kind, name);
    }

    [TestCase("plant/press")]
    [TestCase("HoloLens")]
    public async Task Name_UsedByOneClient_IsNotAnEvent(string hardwareId)
    {
        await _gateway.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        for (var i = 0; i < 6; i++)
        {
            await ReportAsync(client, hardwareId);
            await client.SendAsync(RosbridgeWriter.Publish(RosTopics.JointStates, Gateways.State(i, "a"), RosTimeForm.Sec));
            await client.RoundTripAsync();
            _gateway.Time.Advance(TimeSpan.FromSeconds(1));
        }

        Assert.That((await _gateway.StateAsync()).GetProperty("events").EnumerateArray().Select(one => one.GetProperty("text").GetString()),
            Has.None.Contains("name"));
    }

    // The gateway detects the loss of the former connection later than the client.
    [Test]
    public async Task Name_OfAClientThatReconnects_IsNotAnEvent()
    {
        await _gateway.StartAsync();
        using var former = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        await ReportAsync(former, "HoloLens");
        await former.RoundTripAsync();
        using RawRosbridgeClient second = await ReconnectAsync(), third = await ReconnectAsync();

        var state = await _gateway.StateAsync();
        Assert.That(state.GetProperty("status").GetProperty("text").GetString(), Does.Not.Contain("HoloLens"));
        Assert.That(state.GetProperty("events").GetArrayLength(), Is.Zero);
    }

    [TestCase("websocket")]
    [TestCase("sync")]
    public async Task Connections_AtTheMaximum_AreAnEventUntilThereIsRoom(string server)
    {
        await _gateway.StartAsync(options => options with { MaxConnections = 1 });

        using (await OpenAsync(server))
        {
            await _gateway.BeginsAsync("connection", server);
            var full = await _gateway.EventAsync("connection", server);
            Assert.That(full.GetProperty("text").GetString(), Does.Contain("max-connections"));
            Assert.That(full.GetProperty("level").GetString(), Is.EqualTo("warning"));
        }

        var counters = server == "sync" ? _gateway.Server.SyncConnections : _gateway.Server.WebSocketConnections;
        await Soon.BecomesAsync(() => counters.Open == 0, "the connection has ended");
        _gateway.Time.Advance(TimeSpan.FromSeconds(6));
        await _gateway.EndsAsync("connection", server);
    }

    [Test]
    public async Task Connections_RefusedRepeatedlyAtTheMaximum_AreOneEventWithTheirNumber()
    {
        await _gateway.StartAsync(options => options with { MaxConnections = 1 });
        for (var i = 0; i < 2; i++)
        {
            using (await RawRosbridgeClient.ConnectAsync(_gateway.Server))
            {
                await _gateway.BeginsAsync("connection", "websocket");
                Assert.ThrowsAsync<WebSocketException>(() => RawRosbridgeClient.ConnectAsync(_gateway.Server));
            }

            await Soon.BecomesAsync(() => _gateway.Server.WebSocketConnections.Open == 0, "the connection has ended");
            // The refused client connects again after a moment, so the limit counts as reached in the meantime.
            var full = await _gateway.EventAsync("connection", "websocket");
            Assert.That(full.TryGetProperty("until_utc", out _), Is.False);
        }

        // The gateway updates the event several times per second.
        string Reason() => _gateway.EventAsync("connection", "websocket").Result.GetProperty("reason").GetString();
        await Soon.BecomesAsync(() => Reason() == EventTexts.Connections(1, 2), () => Reason());
        Assert.That((await _gateway.StateAsync()).GetProperty("events").GetArrayLength(), Is.EqualTo(1));
        _gateway.Time.Advance(TimeSpan.FromSeconds(6));
        await _gateway.EndsAsync("connection", "websocket");
    }

    [TestCase("websocket")]
    [TestCase("sync")]
    public async Task Connection_RefusedForDescriptors_IsAnEventAndAMetric(string server)
    {
        await _gateway.StartAsync();
        var counters = server == "sync" ? _gateway.Server.SyncConnections : _gateway.Server.WebSocketConnections;

        counters.CountFailure(new SocketException((int)SocketError.TooManyOpenSockets));

        await _gateway.BeginsAsync("connection", server);
        var refused = await _gateway.EventAsync("connection", server);
        Assert.That(refused.GetProperty("reason").GetString(), Is.EqualTo(EventTexts.RefusedForDescriptors(1)));
        Assert.That(
            (await _gateway.GetAsync("/metrics")).Text,
            Does.Contain($"nowpose_connections_closed_total{{server=\"{server}\",reason=\"{nameof(Closure.DescriptorLimit)}\"}} 1"));
        _gateway.Time.Advance(TimeSpan.FromSeconds(6));
        await _gateway.EndsAsync("connection", server);
    }

    // Connects a headset, which the gateway refuses until the name of its former connection is free.
    async Task<RawRosbridgeClient> ReconnectAsync()
    {
        var again = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        for (var i = 0; i < 3; i++)
        {
            await ReportAsync(again, "HoloLens");
            await again.ExpectErrorAsync(nameof(DropReason.JointTaken));
            _gateway.Time.Advance(TimeSpan.FromSeconds(1));
        }

        await ReportAsync(again, "HoloLens");
        await again.RoundTripAsync();
        return again;
    }

    async Task<IDisposable> OpenAsync(string server) =>
        server == "sync" ? await RawSyncClient.ConnectAsync(_gateway.Server) : await RawRosbridgeClient.ConnectAsync(_gateway.Server);

    static Task ReportAsync(RawRosbridgeClient client, string hardwareId) => client.SendAsync(RosbridgeWriter.Publish(
        RosTopics.Diagnostics, new DiagnosticsMessage(Gateways.Start, hardwareId, [KeyValuePair.Create("state", "connected"), KeyValuePair.Create("pose", "current")]), RosTimeForm.Sec));
}
