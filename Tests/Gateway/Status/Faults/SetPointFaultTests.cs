using Nowpose.Gateway.Hub;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status.Faults;

/// <summary>Tests how the event list reports set-points that are refused. A source may send them only once per motion.</summary>
public class SetPointFaultTests
{
    const string ClientAtArm1 = "rosbridge 127.0.0.1 of the set-points of robot arm1";

    MonitoredGateway _gateway;

    [SetUp]
    public Task SetUp()
    {
        _gateway = new MonitoredGateway();
        return _gateway.StartAsync();
    }

    [TearDown]
    public Task Close() => _gateway.DisposeAsync().AsTask();

    [TestCase("a", "null", 5000, DropReason.NotFinite)]
    [TestCase("a", "1.5", 50000, DropReason.StampInFuture)]
    [TestCase("a\",\"a", "1.5, 2", 5000, DropReason.DuplicateName)]
    public async Task SetPoints_RefusedForTheirContent_AreOneEventUntilAPlanIsAccepted(string joint, string positions, int seconds, DropReason reason)
    {
        using var client = await RawRosbridgeClient.ConnectAsync(_gateway.Server);

        for (var motion = 0; motion < 3; motion++)
        {
            await client.SendAsync(Plan("/arm1/joint_trajectory", joint, positions, seconds));
            await client.ExpectErrorAsync(reason.ToString());
            await _gateway.BeginsAsync("source", ClientAtArm1);
            _gateway.Time.Advance(TimeSpan.FromMinutes(1));
        }

        var refused = await _gateway.EventAsync("source", ClientAtArm1);
        Assert.That(refused.GetProperty("reason").GetString(), Does.Contain(reason.ToString()));
        Assert.That(refused.TryGetProperty("until_utc", out _), Is.False);
        Assert.That((await _gateway.StateAsync()).GetProperty("events").GetArrayLength(), Is.EqualTo(1));

        await client.SendAsync(Plan("/arm1/joint_trajectory", "a", "1.5"));
        await _gateway.EndsAsync("source", ClientAtArm1);
    }

    [Test]
    public async Task SetPoints_OfTwoRobotsAreRefused_AreTwoEvents()
    {
        using var client = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        foreach (var robot in new[] { "/arm1", "/arm2", "" })
        {
            await client.SendAsync(Plan(robot + "/joint_trajectory", "a", "null"));
            await client.ExpectErrorAsync(nameof(DropReason.NotFinite));
        }

        await _gateway.BeginsAsync("source", ClientAtArm1);
        await _gateway.BeginsAsync("source", "rosbridge 127.0.0.1 of the set-points of robot arm2");
        await _gateway.BeginsAsync("source", "rosbridge 127.0.0.1 of the set-points");
        await client.SendAsync(Plan("/arm1/joint_trajectory", "a", "1.5"));
        await _gateway.EndsAsync("source", ClientAtArm1);

        var other = await _gateway.EventAsync("source", "rosbridge 127.0.0.1 of the set-points of robot arm2");
        Assert.That(other.TryGetProperty("until_utc", out _), Is.False);
    }

    // Arm and gripper often have plans of their own.
    [Test]
    public async Task SetPoints_OfOtherJointsAreAccepted_AreStillRefused()
    {
        using var client = await RawRosbridgeClient.ConnectAsync(_gateway.Server);
        await client.SendAsync(Plan("/arm1/joint_trajectory", "gripper", "null"));
        await client.ExpectErrorAsync(nameof(DropReason.NotFinite));
        await _gateway.BeginsAsync("source", ClientAtArm1);

        await client.SendAsync(Plan("/arm1/joint_trajectory", "a", "1.5"));
        await client.RoundTripAsync();
        _gateway.Time.Advance(TimeSpan.FromMinutes(1));

        Assert.That((await _gateway.StateAsync()).GetProperty("status").GetProperty("text").GetString(), Does.Contain("set-points of robot arm1"));
    }

    [TestCase("", "", "first ends")]
    [TestCase("arm1", " of robot arm1", "first ends")]
    [TestCase("arm1", " of robot arm1", "first unadvertises")]
    [TestCase("arm1", " of robot arm1", "second ends")]
    [TestCase("arm1", " of robot arm1", "second unadvertises")]
    public async Task SecondSource_OfSetPoints_AddsOneEventUntilOneOfTheSourcesLeaves(string robot, string ofRobot, string end)
    {
        using HubSource first = _gateway.Server.Hub.OpenSource(), second = _gateway.Server.Hub.OpenSource();
        second.Name = "copy";
        var plan = new JointTrajectoryMessage(Gateways.Start, ["a"], [new JointTrajectoryPoint(TimeSpan.Zero, [1.0])]);
        var which = "copy of the set-points" + ofRobot;

        Assert.That(first.Publish(plan, robot: robot), Is.Null);
        for (var motion = 0; motion < 3; motion++)
        {
            Assert.That(second.Publish(plan, robot: robot)?.What, Is.EqualTo("a"));
            await _gateway.BeginsAsync("source", which);
            _gateway.Time.Advance(TimeSpan.FromMinutes(1));
        }

        Assert.That((await _gateway.EventAsync("source", which)).TryGetProperty("until_utc", out _), Is.False);
        Assert.That((await _gateway.StateAsync()).GetProperty("events").GetArrayLength(), Is.EqualTo(1));

        var leaving = end.StartsWith("first", StringComparison.Ordinal) ? first : second;
        if (end.EndsWith("unadvertises", StringComparison.Ordinal)) leaving.Release(RobotTopic.NameOf(robot, RosTopics.JointTrajectory));
        else leaving.Dispose();
        await _gateway.EndsAsync("source", which);
    }

    static string Plan(string topic, string joint, string positions, int seconds = 5000) =>
        "{\"op\":\"publish\",\"topic\":\"" + topic + "\",\"msg\":{\"header\":{\"stamp\":{\"sec\":" + seconds + ",\"nanosec\":0}},\"joint_names\":[\""
        + joint + "\"],\"points\":[{\"positions\":[" + positions + "],\"time_from_start\":{\"sec\":0,\"nanosec\":0}}]}}";
}
