using System.Net;
using System.Net.Http.Headers;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Status.StatusRequests;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>Tests under which conditions the gateway is ready.</summary>
public class ReadinessTests
{
    [Test]
    public async Task Ready_SourceUsesTheCorrectedSystemClock_IsNotReadyWithAReason()
    {
        // The gateway's clock is one hour behind the system clock, as after a correction of the system clock that it did not follow.
        var behind = new StopwatchControlClock(new ControlTime(DateTime.UtcNow - DateTime.UnixEpoch - TimeSpan.FromHours(1)));
        await using var gateway = await Gateways.StartAsync(clock: behind);
        using var source = await RawRosbridgeClient.ConnectAsync(gateway);
        Assert.That((await GetAsync(gateway, "/readyz")).Status, Is.EqualTo(HttpStatusCode.OK));

        var answer = default((HttpStatusCode Status, string Text, HttpContentHeaders Headers));
        await Soon.BecomesAsync(
            () =>
            {
                var stamp = new ControlTime(DateTime.UtcNow - DateTime.UnixEpoch);
                source.SendAsync(RosbridgeWriter.Publish(
                    RosTopics.JointStates, new JointStateMessage(stamp, ["a"], [0.5]), RosTimeForm.Sec)).GetAwaiter().GetResult();
                answer = GetAsync(gateway, "/readyz").GetAwaiter().GetResult();
                return answer.Status == HttpStatusCode.ServiceUnavailable && answer.Text.Contains("contradict", StringComparison.Ordinal);
            },
            "not ready");

        Assert.That(answer.Text,
            Does.StartWith($"waiting\n{EventTexts.StampsContradictClock(EventTexts.OwnClock)}").And.Contain(StampMessages.SystemRemedy));
        Assert.That((await StateAsync(gateway)).GetProperty("clock").GetProperty("warning").GetString(), Does.Contain(StampMessages.FitsSystemClock));
        Assert.That((await GetAsync(gateway, "/metrics")).Text, Does.Contain("\nnowpose_clock_warning 1\n"));
    }

    [Test]
    public async Task Ready_SourceUsesTheServedSystemClock_IsReady()
    {
        await using var gateway = await Gateways.StartAsync(clock: new SystemControlClock());
        using var source = await RawRosbridgeClient.ConnectAsync(gateway);

        for (var i = 0; i < 50; i++)
        {
            var stamp = new ControlTime(DateTime.UtcNow - DateTime.UnixEpoch);
            await source.SendAsync(RosbridgeWriter.Publish(
                RosTopics.JointStates, new JointStateMessage(stamp, ["a"], [0.5]), RosTimeForm.Sec));
        }

        await source.RoundTripAsync();
        Assert.That(gateway.Drops.Total, Is.Zero);
        Assert.That((await GetAsync(gateway, "/readyz")).Text, Is.EqualTo("ready\n"));
    }

    [Test]
    public async Task Ready_ObserverPublishesAJoint_StaysReadyAndNamesTheClient()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });
        using var observer = await RawRosbridgeClient.ConnectAsync(
            gateway, options => options.SetRequestHeader("Authorization", "Bearer " + Gateways.ObserverToken));

        await observer.SendAsync(Gateways.StateText(1, "invented"));
        await observer.ExpectErrorAsync(nameof(DropReason.NotAllowed));

        Assert.That((await GetAsync(gateway, "/readyz")).Text, Is.EqualTo("ready\n"));
        var metrics = (await GetAsync(gateway, "/metrics", Gateways.ObserverToken)).Text;
        Assert.That(metrics, Does.Not.Contain("invented"));
        await Soon.BecomesAsync(
            () => GetAsync(gateway, "/operations/events", Gateways.ObserverToken).Result.Text.Contains("rosbridge 127.0.0.1 is refused"),
            "the event names the client");
    }

    [Test]
    public async Task Ready_ClockUnsynchronised_IsNotReady()
    {
        await using var gateway = await Gateways.StartAsync(clock: new StopwatchControlClock(Gateways.Start) { IsSynchronised = false });

        var (status, text, _) = await GetAsync(gateway, "/readyz");

        Assert.That(status, Is.EqualTo(HttpStatusCode.ServiceUnavailable));
        Assert.That(text, Does.StartWith("waiting\n" + EventTexts.ClockNotServed(EventTexts.OwnClock)));
        Assert.That((await GetAsync(gateway, "/healthz")).Status, Is.EqualTo(HttpStatusCode.OK), "the gateway is still live");
    }

    [Test]
    public async Task Ready_SourcesExpected_IsNotReadyBeforeTheFirstSource()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { ExpectsSources = true });
        Assert.That((await GetAsync(gateway, "/readyz")).Status, Is.EqualTo(HttpStatusCode.ServiceUnavailable));

        using var source = gateway.Hub.OpenSource();
        source.Publish(Gateways.State(1, "a"));

        Assert.That((await GetAsync(gateway, "/readyz")).Status, Is.EqualTo(HttpStatusCode.OK));
    }
}
