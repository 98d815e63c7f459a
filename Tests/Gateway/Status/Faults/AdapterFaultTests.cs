using System.Net;
using System.Text.Json;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Status.Events;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status.Faults;

/// <summary>Tests how state, /readyz and event list report adapters that are not connected or send no diagnostics.</summary>
public class AdapterFaultTests
{
    MonitoredGateway _gateway;

    [SetUp]
    public void SetUp() => _gateway = new MonitoredGateway();

    [TearDown]
    public Task Close() => _gateway.DisposeAsync().AsTask();

    [Test]
    public async Task Observer_WithTheNameOfAnAdapter_IsRefused()
    {
        await _gateway.StartAsync(options => options with { Tokens = Gateways.Tokens });
        using var client = await RawRosbridgeClient.ConnectAsync(
            _gateway.Server, set => set.SetRequestHeader("Authorization", $"Bearer {Gateways.ObserverToken}"));

        await client.SendAsync(RosbridgeWriter.Publish(
            RosTopics.Diagnostics,
            new DiagnosticsMessage(default, "adapter/press", [KeyValuePair.Create("joint/a", $"fault {_gateway.Since()} made up")]),
            RosTimeForm.Sec));

        Assert.That((await client.ReceiveAsync()).Text, Does.Contain("NotAllowed"));
        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));
    }

    [Test]
    public async Task Adapter_NotConnectedThenSilent_AddsTwoEvents()
    {
        await _gateway.StartAsync();
        _gateway.Report("adapter/press", ("state", "refused"), ("reason", "the certificate is not trusted"));
        _gateway.Time.Advance(EventList.StartGrace);
        await _gateway.BeginsAsync("adapter", "press");
        Assert.That(
            (await _gateway.EventAsync("adapter", "press")).GetProperty("reason").GetString(), Is.EqualTo("refused: the certificate is not trusted"));

        _gateway.Time.Advance(TimeSpan.FromMinutes(5));

        await Soon.BecomesAsync(
            () => _gateway.EventAsync("adapter", "press").Result.GetProperty("what").GetString() == "does not report", "it is silent");
        Assert.That(
            (await _gateway.StateAsync()).GetProperty("adapters").GetArrayLength(), Is.EqualTo(1), "an adapter that is gone stays in the state");
    }

    [Test]
    public async Task Adapter_WithANotice_IsAWarningUntilTheNoticeEnds()
    {
        await _gateway.StartAsync();
        _gateway.Report("adapter/press", ("state", "connected"), ("notice", "emergency stop; release it"));

        await _gateway.BeginsAsync("adapter", "press");
        var one = await _gateway.EventAsync("adapter", "press");
        Assert.That(
            (one.GetProperty("what").GetString(), one.GetProperty("reason").GetString(), one.GetProperty("level").GetString()),
            Is.EqualTo((EventTexts.HasNotice, "emergency stop; release it", "warning")));
        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));

        _gateway.Report("adapter/press", ("state", "connected"));

        await _gateway.EndsAsync("adapter", "press");
    }

    [Test]
    public async Task Ready_OneOfTwoAdaptersNeverReports_IsNotReady()
    {
        await _gateway.StartAsync(options => options with { ExpectsSources = true });
        var lathe = new AdapterState("lathe", null, "status 1");
        _gateway.Server.Expect([() => new AdapterState("press", TimeSpan.FromSeconds(10), null), () => lathe]);
        _gateway.Report("plant/press", ("state", "connected"), ("samples", "7"), ("joint/a", $"live {_gateway.Since()} "));
        _gateway.Publish("a");
        await _gateway.BeginsAsync("adapter", "lathe");
        string[] expected =
        [
            "waiting",
            $"adapter lathe {EventTexts.DoesNotReport}: {EventTexts.StartedAgain(EventTexts.ProgramEnded("status 1"))} "
                + $"(since 2026-11-20 12:00:00 UTC). {EventRemedies.GatewayLog}",
        ];

        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.ServiceUnavailable), Is.EqualTo(expected));
        lathe = lathe with { RunTime = TimeSpan.FromSeconds(0.2) };
        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.ServiceUnavailable), Is.EqualTo(expected), "no diagnostics yet");
        Assert.That((await _gateway.StateAsync()).GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("error"));

        _gateway.Report("plant/lathe", ("state", "connected"), ("samples", "0"));
        // In this test, one source sends both reports. Its name is that in the last report.
        _gateway.Report("plant/press", ("state", "connected"), ("samples", "7"), ("joint/a", $"live {_gateway.Since()} "));

        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));
        await _gateway.EndsAsync("adapter", "lathe");
    }

    [Test]
    public async Task Ready_AdapterNotConnected_NamesTheAdapterInsteadOfItsJointsAndObjects()
    {
        const string Why = "no OPC UA server responds at opc.tcp://press:4840";
        await _gateway.StartAsync(options => options with { ExpectsSources = true });
        void Report(string state, string values) => _gateway.Report(
            "plant/press", ("state", state), ("reason", Why), ("samples", "7"), ("joint/a", $"{values} {_gateway.Since()} why"),
            ("joint/b", $"{values} {_gateway.Since()} why"), ("frame/part", $"{values} {_gateway.Since()} why"),
            ("signal/closed", $"{values} {_gateway.Since()} why"));
        Report("waiting", "missing");
        await _gateway.BeginsAsync("adapter", "press");

        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.ServiceUnavailable), Is.EqualTo(new[]
        {
            "waiting", $"{EventTexts.NotConnected("press")}: waiting: {Why} (since 2026-11-20 12:00:00 UTC)",
        }));
        var state = await _gateway.StateAsync();
        Assert.That(
            state.GetProperty("events").EnumerateArray().Select(one => one.GetProperty("kind").GetString()), Is.EqualTo(new[] { "adapter" }));
        Assert.That(state.GetProperty("joints").GetArrayLength(), Is.EqualTo(2), "the joints keep their own states");

        Report("connected", "missing");

        Assert.That(
            await _gateway.ReadyAsync(HttpStatusCode.ServiceUnavailable),
            Has.Length.EqualTo(3).And.Some.StartsWith($"joint a (press) {EventTexts.IsMissing}"));
    }

    [Test]
    public async Task Adapter_ConnectsAgain_AddsAnEventOfAJointOnlyIfItRemainsMissing()
    {
        await _gateway.StartAsync();
        _gateway.Time.Advance(2 * EventList.StartGrace);
        void Report(string state) => _gateway.Report(
            "adapter/press", ("state", state), ("samples", "7"), ("joint/a", $"missing {_gateway.Since()} no value yet"));
        Report("waiting");
        await _gateway.BeginsAsync("adapter", "press");

        Report("connected");
        await _gateway.EndsAsync("adapter", "press");
        var first = await _gateway.EventAsync("joint", "a (press)");
        _gateway.Time.Advance(1.1 * EventList.StartGrace);
        Report("connected");

        Assert.That(first.ValueKind, Is.EqualTo(JsonValueKind.Undefined));
        await _gateway.BeginsAsync("joint", "a (press)");
    }

    [Test]
    public async Task Start_PlantConnectsWithinTheGracePeriod_AddsNoEvent()
    {
        await _gateway.StartAsync(
            options => options with { ExpectsSources = true }, new StopwatchControlClock(Gateways.Start) { IsSynchronised = false });
        _gateway.Report("adapter/press", ("state", "connecting"), ("samples", "0"), ("joint/a", $"missing {_gateway.Since()} no value yet"));
        _gateway.Report("adapter/lathe", ("state", "waiting"), ("samples", "7"));
        await _gateway.BeginsAsync("adapter", "lathe");

        Assert.That(
            (await _gateway.StateAsync()).GetProperty("events").EnumerateArray().Select(one => one.GetProperty("which").GetString()),
            Is.EqualTo(new[] { "lathe" }),
            "an adapter that has published samples was connected before");
        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.ServiceUnavailable), Has.Length.EqualTo(3), "the adapter, the clock and the joint are reported");
        Assert.That((await _gateway.StateAsync()).GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("error"));

        _gateway.Report("adapter/press", ("state", "connected"), ("samples", "1"), ("joint/a", $"live {_gateway.Since()} "));
        _gateway.Publish("a");
        _gateway.Time.Advance(EventList.StartGrace);
        await _gateway.BeginsAsync("clock", "own");

        Assert.That(
            (await _gateway.StateAsync()).GetProperty("events").EnumerateArray().Select(one => one.GetProperty("kind").GetString()),
            Does.Not.Contain("source"));
        Assert.That(_gateway.Logged("is missing"), Is.False);
        Assert.That(_gateway.Logged("adapter press is not connected"), Is.False);
    }
}
