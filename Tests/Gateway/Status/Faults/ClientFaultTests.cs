using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status.Faults;

/// <summary>Tests how the event list reports a second client with a used name, whose reports the gateway refuses.</summary>
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

    // The gateway detects the loss of the former connection later than the client.
    [Test]
    public async Task Name_OfAClientThatReconnects_IsNotAnEvent()
    {
        await _gateway.StartAsync();
        using var former = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        await ReportAsync(former, "HoloLens");
        await former.RoundTripAsync();
        using var again = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        for (var i = 0; i < 3; i++)
        {
            await ReportAsync(again, "HoloLens");
            await again.ExpectErrorAsync(nameof(DropReason.JointTaken));
            _gateway.Time.Advance(TimeSpan.FromSeconds(1));
        }

        await ReportAsync(again, "HoloLens");
        await again.RoundTripAsync();

        var state = await _gateway.StateAsync();
        Assert.That(state.GetProperty("status").GetProperty("text").GetString(), Does.Not.Contain("HoloLens"));
        Assert.That(state.GetProperty("events").GetArrayLength(), Is.Zero);
    }

    static Task ReportAsync(RawRosbridgeClient client, string hardwareId) => client.SendAsync(RosbridgeWriter.PublishDiagnostics(
        RosTopics.Diagnostics, new DiagnosticsMessage(Gateways.Start, hardwareId, [KeyValuePair.Create("state", "connected"), KeyValuePair.Create("pose", "current")]), RosTimeForm.Sec));
}
