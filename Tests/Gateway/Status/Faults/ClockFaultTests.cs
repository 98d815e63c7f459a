using System.Net;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status.Faults;

/// <summary>Tests how state, /readyz, event list and headsets report a control clock that does not run in real time.</summary>
public class ClockFaultTests
{
    // The exchanges have times in the future, so that the clock counts as measured however long the test takes.
    static readonly TimeSpan Later = TimeSpan.FromMinutes(10);

    MonitoredGateway _gateway;
    HeadsetTime _time;
    ControlTime _shown;

    [SetUp]
    public void SetUp() => _gateway = new MonitoredGateway();

    [TearDown]
    public Task Close() => _gateway.DisposeAsync().AsTask();

    [Test]
    public async Task ControlClock_AtHalfSpeedThenRight_IsOneEventInsteadOfThoseOfItsConsequences()
    {
        await _gateway.StartAsync();
        _gateway.Publish("a");
        (_time, _shown) = (_gateway.Server.PlantClocks.Counter.Now + Later, Gateways.Start);
        Run("plc", 0.5, 10);
        _gateway.Report("goggles", ("pose", "unsynchronised"));
        var headline = EventTexts.ClockAtWrongRate("plc", 0.5);

        var lines = await _gateway.ReadyAsync(HttpStatusCode.ServiceUnavailable);
        Assert.That(lines, Has.Length.EqualTo(2));
        Assert.That(lines[1], Does.StartWith(headline + " (since ").And.EndWith(EventRemedies.ClockRate));
        await _gateway.BeginsAsync("clock", "plc");
        var state = await _gateway.StateAsync();
        Assert.That(
            state.GetProperty("events").EnumerateArray().Select(one => one.GetProperty("what").GetString()), Is.EqualTo(new[] { EventTexts.RunsAtWrongRate }));
        Assert.That(state.GetProperty("status").GetProperty("text").GetString(), Is.EqualTo($"{headline}. {EventRemedies.ClockRate}"));
        Assert.That(state.GetProperty("clock").GetProperty("is_served").GetBoolean(), Is.False);
        var joint = state.GetProperty("joints")[0];
        Assert.That(joint.GetProperty("state").GetString(), Is.EqualTo("fault"));
        Assert.That(joint.GetProperty("reason_word").GetString(), Is.EqualTo(JointFaultReasons.ClockRate));
        using var headset = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        await headset.SendAsync(RosbridgeWriter.Subscribe(RosTopics.JointStatus, "diagnostic_msgs/DiagnosticArray"));
        string status;
        do status = await headset.ReceiveTextAsync();
        while (!status.Contains(headline, StringComparison.Ordinal));
        Assert.That(status, Does.Contain(EventRemedies.ClockRate));

        Run("plc", 1, 30);

        await _gateway.EndsAsync("clock", "plc");
        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));
        Assert.That((await _gateway.StateAsync()).GetProperty("joints")[0].GetProperty("state").GetString(), Is.EqualTo("live"));
        Assert.That(_gateway.Log.Count(line => line.Contains(headline, StringComparison.Ordinal)), Is.EqualTo(2), string.Join('\n', _gateway.Log));
    }

    [Test]
    public async Task OtherClock_AtHalfSpeed_IsAnEventOfAGatewayThatIsReady()
    {
        await _gateway.StartAsync();
        _gateway.Publish("a");
        (_time, _shown) = (_gateway.Server.PlantClocks.Counter.Now + Later, Gateways.Start);
        Run("plc", 1, 10);
        Run("cell", 0.5, 10);

        await _gateway.BeginsAsync("clock", "cell");
        Assert.That(await _gateway.ReadyAsync(HttpStatusCode.OK), Is.EqualTo(new[] { "ready" }));
    }

    void Run(string clock, double rate, double seconds)
    {
        var (delay, interval) = (TimeSpan.FromMilliseconds(1), TimeSpan.FromSeconds(0.2));
        for (var end = _time + TimeSpan.FromSeconds(seconds); _time < end; _time += interval, _shown += interval * rate)
            _gateway.Server.PlantClocks.Find(clock).Add(new SyncExchange(_time - delay, _shown, _shown, _time + delay));
    }
}
