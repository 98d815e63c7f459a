using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;
using Nowpose.Headless.Tests.Gateway.Status;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Cell;

public class RobotNamespaceTests
{
    GatewayServer _gateway;
    RawRosbridgeClient _first, _second;

    [SetUp]
    public async Task StartAsync()
    {
        _gateway = await Gateways.StartAsync();
        _first = await RawRosbridgeClient.ConnectAsync(_gateway);
        _second = await RawRosbridgeClient.ConnectAsync(_gateway);
    }

    [TearDown]
    public async Task StopAsync()
    {
        _first.Dispose();
        _second.Dispose();
        await _gateway.DisposeAsync();
    }

    static string State(string robot, double position, string joint = "a") =>
        RosbridgeWriter.Publish(RobotTopic.NameOf(robot, RosTopics.JointStates), Gateways.State(position, joint), RosTimeForm.Sec);

    static string Urdf(string name) => $"<robot name='{name}'><link name='base'/></robot>";

    [Test]
    public async Task Publish_EqualJointNamesOfTwoRobots_StaySeparate()
    {
        using var one = await RawRosbridgeClient.ConnectAsync(_gateway);
        using var two = await RawRosbridgeClient.ConnectAsync(_gateway);
        using var none = await RawRosbridgeClient.ConnectAsync(_gateway);
        await one.SubscribeAsync("/arm1/joint_states", "sensor_msgs/JointState");
        await two.SubscribeAsync("/arm2/joint_states", "sensor_msgs/msg/JointState");
        await none.SubscribeAsync(RosTopics.JointStates);

        await _first.SendAsync(State("arm1", 1));
        await _second.SendAsync(State("arm2", 2));
        await _first.SendAsync(State("", 3));
        await _first.RoundTripAsync();
        await _second.RoundTripAsync();

        var text = await one.ReceiveTextAsync();
        Assert.That(text, Does.Contain("\"topic\":\"/arm1/joint_states\"").And.Contain("\"secs\"").And.Contain("[1.0]"));
        Assert.That((await two.ReceiveAsync()).JointState.Positions, Is.EqualTo(new[] { 2.0 }));
        Assert.That((await none.ReceiveAsync()).JointState.Positions, Is.EqualTo(new[] { 3.0 }));
        await one.RoundTripAsync();
        await two.RoundTripAsync();
        await none.RoundTripAsync();
    }

    [Test]
    public async Task SecondSource_ForAJointOfARobot_IsRefusedUntilTheFirstEnds()
    {
        await _first.SendAsync(State("arm1", 1));
        await _first.RoundTripAsync();

        await _second.SendAsync(State("arm1", 2));

        await _second.ExpectErrorAsync($"{CellMessageFaults.Of("a", DropReason.JointTaken)}, rosbridge 127.0.0.1 ({DropReason.JointTaken})");
        _first.Dispose();
        await Soon.BecomesAsync(() => _gateway.WebSocketConnections.Open == 1, "the first has disconnected");
        await _second.SendAsync(State("arm1", 2));
        await _second.RoundTripAsync();
    }

    [Test]
    public async Task Description_SourceWithTwoRobots_SubscriberReceivesOnlyThatOfItsRobot()
    {
        await _first.SendAsync(RosbridgeWriter.Publish("/arm1/robot_description", new StringMessage(Urdf("one"))));
        await _first.SendAsync(RosbridgeWriter.Publish("/arm2/robot_description", new StringMessage(Urdf("two"))));
        await _first.RoundTripAsync();

        await _second.SendAsync(RosbridgeWriter.Subscribe("/arm2/robot_description", "std_msgs/String"));

        Assert.That((await _second.ReceiveAsync()).Data, Is.EqualTo(Urdf("two")));
        await _second.SendAsync(RosbridgeWriter.Publish("/arm2/robot_description", new StringMessage(Urdf("three"))));
        await _second.ExpectErrorAsync(CellMessageFaults.Of("the robot", DropReason.JointTaken));
        await _second.SubscribeAsync(RosTopics.RobotDescription);
    }

    [TestCase("arm1", "q", "", "arm1/q")]
    [TestCase("", "arm1/q", "arm1", "q")]
    public async Task Joint_CellWideNameOfAnotherRobotsJoint_IsRefused(string robot, string joint, string otherRobot, string otherJoint)
    {
        await _first.SendAsync(State(robot, 1, joint));
        await _first.RoundTripAsync();

        await _second.SendAsync(State(otherRobot, 2, otherJoint));

        await _second.ExpectErrorAsync(
            $"{otherJoint} {DropMessages.SameCellName(RobotTopic.NameOf(robot, RosTopics.JointStates), joint)}, rosbridge 127.0.0.1 ({DropReason.JointTaken})");
        Assert.That(_gateway.Drops[DropReason.JointTaken], Is.EqualTo(1));
    }

    // The dead robot must stay in the list of joints.
    [TestCase("arm1", "q", "", "arm1/q")]
    [TestCase("", "arm1/q", "arm1", "q")]
    public async Task Joint_CellWideNameOfAJointWhoseSourceFailed_IsRefused(string robot, string joint, string otherRobot, string otherJoint)
    {
        await _first.SendAsync(State(robot, 1, joint));
        await _first.RoundTripAsync();
        _first.Dispose();
        await Soon.BecomesAsync(() => _gateway.WebSocketConnections.Open == 1, "the first has disconnected");

        await _second.SendAsync(State(otherRobot, 2, otherJoint));

        await _second.ExpectErrorAsync(DropMessages.SameCellName(RobotTopic.NameOf(robot, RosTopics.JointStates), joint));
        await _second.SendAsync(State(robot, 2, joint));
        await _second.RoundTripAsync(); // another source of the same joint may take it over
    }

    [Test]
    public async Task Joint_SlashInItsName_IsAcceptedWithoutARobotOfThatNamespace()
    {
        await _first.SendAsync(State("", 1, "panda/joint1"));
        await _first.SendAsync(State("", 1, "panda/link/joint1"));
        await _first.SendAsync(State("arm1", 1, "panda/joint1"));
        await _first.RoundTripAsync();

        var joints = (await StatusRequests.StateAsync(_gateway)).GetProperty("joints").EnumerateArray();
        Assert.That(
            joints.Select(joint => (joint.GetProperty("name").GetString(), joint.GetProperty("robot").GetString())),
            Is.EqualTo(new[] { ("arm1/panda/joint1", "arm1"), ("panda/joint1", ""), ("panda/link/joint1", "") }));
    }

    // Diagnostics do not contain the robot of a headset, so the age of its samples is known only with one robot.
    [TestCase("", true)]
    [TestCase("arm1", false)]
    public async Task Budget_JointsWithASlashInTheName_IsKnownWithOneRobot(string robot, bool isKnown)
    {
        await _first.SendAsync(State("", 1, "a"));
        await _first.SendAsync(State(robot, 1, "panda/b"));
        await _first.SendAsync(RosbridgeWriter.Publish(
            RosTopics.Diagnostics, new DiagnosticsMessage(default, "h1", [KeyValuePair.Create("l_app_ms", "50")]), RosTimeForm.Sec));
        await _first.RoundTripAsync();

        var budget = (await StatusRequests.StateAsync(_gateway)).GetProperty("headsets")[0].GetProperty("budget_ms");

        Assert.That(budget.TryGetProperty("plant", out var plant) && plant.ValueKind == System.Text.Json.JsonValueKind.Number, Is.EqualTo(isKnown));
    }

    [Test]
    public async Task SetPoints_SourceWithTwoRobots_SubscriberReceivesOnlyThoseOfItsRobot()
    {
        foreach (var robot in new[] { "arm1", "arm2" })
            await _first.SendAsync(RosbridgeWriter.Publish(
                $"/{robot}/joint_trajectory",
                new JointTrajectoryMessage(Gateways.Start, ["a"], [new JointTrajectoryPoint(TimeSpan.Zero, [robot[^1] - '0'])]), RosTimeForm.Sec));
        await _first.RoundTripAsync();

        await _second.SendAsync(RosbridgeWriter.Subscribe("/arm1/joint_trajectory"));

        Assert.That((await _second.ReceiveAsync()).JointTrajectory.Points[0].Positions, Is.EqualTo(new[] { 1.0 }));
        await _second.RoundTripAsync();
    }

    [TestCase("subscribe", "")]
    [TestCase("advertise", "")]
    [TestCase("publish", ",\"msg\":{}")]
    public async Task Request_InvalidNamespace_ReceivesAStatus(string op, string rest)
    {
        foreach (var robot in new[] { "1arm", "arm-1", "a/b", new string('r', 33) })
        {
            await _first.SendAsync($"{{\"op\":\"{op}\",\"topic\":\"/{robot}/joint_states\"{rest}}}");
            await _first.ExpectErrorAsync($"{op} /{robot}/joint_states dropped: {DropMessages.Of(DropReason.InvalidNamespace)}");
        }

        Assert.That(_gateway.Drops[DropReason.InvalidNamespace], Is.EqualTo(4));
        Assert.That(_gateway.Drops.Total, Is.EqualTo(4));
    }

    [TestCase("/arm1/joint_states", "sensor_msgs/JointState")]
    [TestCase("/arm1/joint_trajectory", "trajectory_msgs/JointTrajectory")]
    [TestCase("/arm1/robot_description", "std_msgs/String")]
    [TestCase("/tf", "tf2_msgs/TFMessage")]
    [TestCase("/tf_static", "tf2_msgs/TFMessage")]
    [TestCase("/signals", "nowpose_msgs/Signals")]
    public async Task Request_WrongType_ReceivesAStatusWithTheCorrectType(string topic, string type)
    {
        await _first.SendAsync(RosbridgeWriter.Subscribe(topic, "sensor_msgs/Image"));
        await _first.ExpectErrorAsync($"subscribe {topic} dropped: {RequestMessages.OtherType(topic, type, "sensor_msgs/Image")}");
        await _first.SendAsync(RosbridgeWriter.Advertise(topic, "sensor_msgs/Image"));
        await _first.ExpectErrorAsync($"advertise {topic} dropped: {RequestMessages.OtherType(topic, type, "sensor_msgs/Image")}");
    }

    [Test]
    public async Task Publish_ManyRobots_AcceptsUpTo16()
    {
        for (var i = 0; i < 16; i++) await _first.SendAsync(State($"arm{i}", i));
        await _first.SendAsync(State("", 1));
        await _first.RoundTripAsync();

        await _second.SendAsync(State("arm16", 1));
        await _second.ExpectErrorAsync($"{CellMessageFaults.Of("robot arm16", DropReason.TooManyRobots)} ({DropReason.TooManyRobots})");
        await _second.SendAsync(RosbridgeWriter.Advertise("/arm16/joint_states", null));
        await _second.ExpectErrorAsync("TooManyRobots");
        await _second.SendAsync(RosbridgeWriter.Publish("/arm16/robot_description", new StringMessage(Urdf("r"))));
        await _second.ExpectErrorAsync("TooManyRobots");

        Assert.That(_gateway.Drops[DropReason.TooManyRobots], Is.EqualTo(3));
        _first.Dispose();
        await Soon.BecomesAsync(() => _gateway.WebSocketConnections.Open == 1, "the first has disconnected");
        await _second.SendAsync(State("arm16", 1));
        await _second.RoundTripAsync();
    }

    [Test]
    public async Task Publish_NewRobot_ReplacesADescribedRobotWithoutASource()
    {
        for (var i = 0; i < 16; i++) await _first.SendAsync(RosbridgeWriter.Publish($"/arm{i}/robot_description", new StringMessage(Urdf("r"))));
        await _first.RoundTripAsync();
        _first.Dispose();
        await Soon.BecomesAsync(() => _gateway.WebSocketConnections.Open == 1, "the source has disconnected");
        Assert.That(_gateway.Hub.Robots, Has.Count.EqualTo(16), "the robot descriptions are kept");

        await _second.SendAsync(State("new", 1));
        await _second.RoundTripAsync();

        Assert.That(_gateway.Hub.Robots, Has.Count.EqualTo(16).And.None.EqualTo("arm0").And.Some.EqualTo("new"));
        Assert.That(_gateway.Hub.DescriptionOf("arm0"), Is.Null);
        Assert.That(_gateway.Hub.DescriptionOf("arm1"), Is.Not.Null);
    }

    [Test]
    public async Task Rosapi_TopicsOfARobot_AreListedWithTheirTypes()
    {
        await _first.SendAsync(State("arm1", 1));
        await _first.RoundTripAsync();

        await _second.SendAsync(RosbridgeWriter.CallService("/rosapi/topics", "1"));
        Assert.That(await _second.ReceiveTextAsync(), Does.Contain("\"/arm1/joint_states\"").And.Contain("\"/arm1/robot_description\"")
            .And.Contain("\"/tf\"").And.Contain("\"/tf_static\"").And.Contain("\"/signals\"").And.Contain("\"nowpose_msgs/Signals\""));
        await _second.SendAsync("""{"op":"call_service","service":"/rosapi/topic_type","args":{"topic":"/arm1/joint_states"}}""");
        Assert.That(await _second.ReceiveTextAsync(), Does.Contain("\"type\":\"sensor_msgs/JointState\""));
        await _second.SendAsync("""{"op":"call_service","service":"/rosapi/message_details","args":{"type":"tf2_msgs/TFMessage"}}""");
        Assert.That(await _second.ReceiveTextAsync(), Does.Contain("geometry_msgs/TransformStamped").And.Contain("geometry_msgs/Quaternion"));
        await _second.SendAsync("""{"op":"call_service","service":"/rosapi/topics_and_raw_types","args":{}}""");
        Assert.That(await _second.ReceiveTextAsync(), Does.Contain("string[] name\\nfloat64[] value"));
    }

    [Test]
    public async Task Publish_CellTopicsByAnObserver_IsRefused()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });
        using var observer = await RawRosbridgeClient.ConnectAsync(
            gateway, options => options.SetRequestHeader("Authorization", "Bearer " + Gateways.ObserverToken));

        foreach (var text in new[]
        {
            State("arm1", 1), CellTexts.Tf(CellTexts.Frame("box")), CellTexts.TfStatic(CellTexts.Frame("box")), CellTexts.SignalsText(("grip", 1)),
            RosbridgeWriter.Publish("/arm1/robot_description", new StringMessage(Urdf("r"))), RosbridgeWriter.Advertise("/tf", null),
            RosbridgeWriter.Advertise("/arm1/joint_trajectory", null),
        })
        {
            await observer.SendAsync(text);
            await observer.ExpectErrorAsync("role");
        }

        Assert.That(gateway.Drops[DropReason.NotAllowed], Is.EqualTo(7));
        Assert.That(gateway.Hub.Robots, Is.Empty);
        await observer.SubscribeAsync(RosTopics.Signals);
        await observer.SubscribeAsync(RosTopics.Tf);
        await observer.SubscribeAsync("/arm1/joint_states");
    }
}
