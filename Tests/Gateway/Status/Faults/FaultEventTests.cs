using System.Net;
using System.Text.Json;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Status.Events;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status.Faults;

/// <summary>Tests the events for faults of the gateway itself, and the download of the event list.</summary>
public class FaultEventTests
{
    MonitoredGateway _gateway;

    [SetUp]
    public void SetUp() => _gateway = new MonitoredGateway();

    [TearDown]
    public Task Close() => _gateway.DisposeAsync().AsTask();

    [Test]
    public async Task Clock_NotServed_AddsAnEventAndAReason()
    {
        await _gateway.StartAsync(clock: new StopwatchControlClock(Gateways.Start) { IsSynchronised = false });

        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.ServiceUnavailable), Is.EqualTo(new[]
        {
            "waiting",
            $"{EventTexts.ClockNotServed(EventTexts.OwnClock)}: {EventTexts.ClockState("converging")} (since 2026-11-20 12:00:00 UTC)",
        }));
        _gateway.Time.Advance(EventList.StartGrace);
        await _gateway.BeginsAsync("clock", "own");
    }

    [Test]
    public async Task Certificate_AboutToExpire_AddsAnEvent()
    {
        using var certificate = CertificateFiles.Generate();
        _gateway.Time.Advance(certificate.NotAfter.ToUniversalTime() - TimeSpan.FromDays(3) - _gateway.Time.GetUtcNow());
        await _gateway.StartAsync(options => options with { Certificate = certificate });

        await Soon.BecomesAsync(() => _gateway.Logged("the gateway's certificate is about to expire"), "it is in the log");
        Assert.That(_gateway.Logged("has expired"), Is.False);
        _gateway.Time.Advance(TimeSpan.FromDays(4));
        await Soon.BecomesAsync(() => _gateway.Logged("the gateway's certificate has expired"), "it is in the log");
    }

    [Test]
    public async Task Watch_SubscriberThrows_IsLoggedAndTheWatchContinues()
    {
        await _gateway.StartAsync();
        using var broken = _gateway.Server.Hub.Subscribe(RosTopics.JointStatus, message =>
        {
            if (((DiagnosticsMessage)message.Content).Values.Count > 0) throw new InvalidOperationException("no status today");
        });

        _gateway.Time.Advance(EventList.StartGrace);
        _gateway.Report("adapter/press", ("state", "refused"), ("joint/a", $"missing {_gateway.Since()} "));

        await Soon.BecomesAsync(
            () => _gateway.Logged("status: the state could not be updated (InvalidOperationException: no status today)"), "it is in the log");
        _gateway.Report("adapter/second", ("state", "refused"));
        _gateway.Time.Advance(EventList.StartGrace);
        await _gateway.BeginsAsync("adapter", "second");
    }

    [TestCase(null, HttpStatusCode.Unauthorized)]
    [TestCase(Gateways.ObserverToken, HttpStatusCode.OK)]
    public async Task Events_Downloaded_RequireATokenThatMayReadTheState(string token, HttpStatusCode expected)
    {
        await _gateway.StartAsync(options => options with { Tokens = Gateways.Tokens });

        Assert.That((await _gateway.GetAsync("/operations/events", token)).Status, Is.EqualTo(expected));
    }

    [Test]
    public async Task Events_Downloaded_AreJsonOrCsv()
    {
        await _gateway.StartAsync();
        _gateway.Publish("a");
        _gateway.Time.Advance(TimeSpan.FromSeconds(2));
        await _gateway.BeginsAsync("joint", "a (gateway)");

        var (_, json, headers) = await _gateway.GetAsync("/operations/events");
        Assert.That(JsonDocument.Parse(json).RootElement[0].GetProperty("which").GetString(), Is.EqualTo("a (gateway)"));
        Assert.That(headers.ContentDisposition.DispositionType, Is.EqualTo("attachment"));
        var (_, csv, type) = await _gateway.GetAsync("/operations/events?format=csv");
        Assert.That(
            csv.Split("\r\n")[1],
            Does.StartWith("1,\"joint\",\"a (gateway)\",\"is stale\",")
                .And.EndsWith($". {EventRemedies.Source}\""));
        Assert.That(type.ContentType.MediaType, Is.EqualTo("text/csv"));
        Assert.That((await _gateway.GetAsync("/operations/events?format=xml")).Status, Is.EqualTo(HttpStatusCode.BadRequest));
    }
}
