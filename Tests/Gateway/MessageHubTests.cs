using System.Text;
using NUnit.Framework;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

public class MessageHubTests
{
    readonly List<HubMessage> _received = [];
    MessageHub _hub;

    [SetUp]
    public void SetUp()
    {
        _hub = new MessageHub();
        _received.Clear();
        _hub.Subscribe(RosTopics.JointStates, _received.Add);
    }

    [Test]
    public void Publish_JointOfAnotherSource_PublishesTheOtherJoints()
    {
        using var first = _hub.OpenSource();
        using var second = _hub.OpenSource();
        first.Publish(Gateways.State(1, "a", "b"));
        var state = new JointStateMessage(Gateways.Start, ["c", "b", "d"], [2, 3, 4], [5, 6, 7], [8, 9, 10]);

        Assert.That(second.Publish(state), Is.EqualTo(new Refusal(DropReason.JointTaken, "b", first, LeftOut: 1)));
        var published = (JointStateMessage)_received[^1].Content;
        Assert.That(published.Names, Is.EqualTo(new[] { "c", "d" }));
        double[][] numbers = [published.Positions, published.Velocities, published.Accelerations];
        Assert.That(numbers, Is.EqualTo(new double[][] { [2, 4], [5, 7], [8, 10] }));

        first.Dispose();
        Assert.That(second.Publish(state), Is.Null);
        Assert.That(((JointStateMessage)_received[^1].Content).Names, Is.EqualTo(state.Names));
    }

    [Test]
    public void Publish_ManyJointsOfAnotherSource_ReportsAtMostTheMaximum()
    {
        using var first = _hub.OpenSource();
        using var second = _hub.OpenSource();
        var names = Enumerable.Range(0, ProtocolLimits.Joints - 1).Select(i => "j" + i).ToArray();
        first.Publish(Gateways.State(1, names));
        var reported = new List<string>();
        _hub.Refused += (_, _, name, _) => reported.Add(name);

        var refusal = second.Publish(Gateways.State(2, [.. names, "free"]));

        Assert.That(refusal?.LeftOut, Is.EqualTo(names.Length));
        Assert.That(reported, Is.EqualTo(names.Take(JointOwners.MaxReported)));
        Assert.That(((JointStateMessage)_received[^1].Content).Names, Is.EqualTo(new[] { "free" }));
    }

    [Test]
    public void Publish_AllJointsOfAnotherSource_RefusesTheMessage()
    {
        using var first = _hub.OpenSource();
        using var second = _hub.OpenSource();
        first.Publish(Gateways.State(1, "a", "b"));

        Assert.That(second.Publish(Gateways.State(2, "b", "a")), Is.EqualTo(new Refusal(DropReason.JointTaken, "b", first)));
        Assert.That(_received.Count, Is.EqualTo(1));
    }

    [Test]
    public void Publish_OneSourceWithOtherJointsInEachMessage_LeavesRoomForOtherSources()
    {
        using var source = _hub.OpenSource();
        using var other = _hub.OpenSource();
        for (var i = 0; i < JointOwners.MaxNames; i++) source.Publish(Gateways.State(i + 1, "joint" + i));

        Assert.That(source.Publish(Gateways.State(2, "one more"))?.Rule, Is.EqualTo(DropMessages.TooManyNamesOfSource(JointOwners.MaxNamesOfSource)));
        Assert.That(other.Publish(Gateways.State(2, "one more")), Is.Null);
    }

    [Test]
    public void Publish_OtherJointsInEachMessage_IsRefusedAboveTheMaximumUntilTheTopicIsReleased()
    {
        HubSource[] sources = [_hub.OpenSource(), _hub.OpenSource()];
        using var other = _hub.OpenSource();
        for (var i = 0; i < JointOwners.MaxNames; i++)
            Assert.That(sources[i / JointOwners.MaxNamesOfSource].Publish(Gateways.State(i + 1, "joint" + i)), Is.Null);
        var source = sources[0];

        Assert.That(source.Publish(Gateways.State(2, "joint0", "one more"))?.Reason, Is.EqualTo(DropReason.TooManyJoints));
        Assert.That(other.Publish(Gateways.State(2, "one more"))?.Reason, Is.EqualTo(DropReason.TooManyJoints));
        Assert.That(source.Publish(Gateways.State(2, "joint0", "joint1")), Is.Null, "no new joint");
        Assert.That(source.Publish(Plan(1, "one more")), Is.Null, "another topic");
        Assert.That(source.Publish(Gateways.State(2, "one more"), robot: "arm"), Is.Null, "another robot");

        source.Release(RosTopics.JointStates);
        Assert.That(other.Publish(Gateways.State(2, "one more")), Is.Null);
    }

    [Test]
    public void Publish_ArmAndGripperSeparately_PublishesBoth()
    {
        using var arm = _hub.OpenSource();
        using var gripper = _hub.OpenSource();

        Assert.That(arm.Publish(Gateways.State(1, "a")), Is.Null);
        Assert.That(gripper.Publish(Gateways.State(1, "g")), Is.Null);
        Assert.That(_received.Count, Is.EqualTo(2));
    }

    [Test]
    public void Dispose_Source_ReleasesItsJoints()
    {
        var first = _hub.OpenSource();
        using var second = _hub.OpenSource();
        first.Publish(Gateways.State(1, "a"));

        first.Dispose();

        Assert.That(second.Publish(Gateways.State(2, "a")), Is.Null);
    }

    [Test]
    public void Release_OneTopic_KeepsTheOthers()
    {
        using var first = _hub.OpenSource();
        using var second = _hub.OpenSource();
        first.Publish(Gateways.State(1, "a"));
        first.Describe("<robot/>");

        first.Release(RosTopics.JointStates);

        Assert.That(second.Publish(Gateways.State(2, "a")), Is.Null);
        Assert.That(second.Describe("<other/>"), Is.Not.Null);
        Assert.That(first.Publish(Gateways.State(1, "a"))?.What, Is.EqualTo("a"));
    }

    [Test]
    public void Subscribe_AfterTheDescription_ReceivesTheNewestDescription()
    {
        using var source = _hub.OpenSource();
        source.Describe("<old/>");
        source.Describe("<new/>");

        var received = new List<HubMessage>();
        _hub.Subscribe(RosTopics.RobotDescription, received.Add);

        Assert.That(received.Count, Is.EqualTo(1));
        Assert.That(Encoding.UTF8.GetString(received[0].Utf8(RosTimeForm.Sec).Span), Does.Contain("<new/>"));
    }

    [Test]
    public void Subscription_Disposed_ReceivesNoMessages()
    {
        var received = new List<HubMessage>();
        using var source = _hub.OpenSource();
        _hub.Subscribe(RosTopics.JointStates, received.Add).Dispose();

        source.Publish(Gateways.State(1, "a"));

        Assert.That(received, Is.Empty);
        Assert.That(_received.Count, Is.EqualTo(1));
    }

    [Test]
    public void Dispose_SubscriptionsToManyTopics_RemovesTheTopics()
    {
        var before = _hub.Topics;
        var other = _hub.Subscribe("/other", _ => { });
        for (var i = 0; i < 1000; i++)
        {
            var twice = new[] { _hub.Subscribe($"/topic{i}", _ => { }), _hub.Subscribe($"/topic{i}", _ => { }) };
            foreach (var subscription in twice) subscription.Dispose();
            // Disposing a subscription a second time must have no effect.
            twice[0].Dispose();
        }

        Assert.That(_hub.Topics, Is.EqualTo(before + 1));
        other.Dispose();
        Assert.That(_hub.Topics, Is.EqualTo(before));
    }

    [Test]
    public void Subscribe_FirstSubscriberOfATopic_ReceivesTheDescriptionAndLaterMessages()
    {
        using var source = _hub.OpenSource();
        _hub.Subscribe(RosTopics.RobotDescription, _ => { }).Dispose();
        source.Describe("<robot/>");
        var received = new List<HubMessage>();
        _hub.Subscribe(RosTopics.RobotDescription, received.Add);

        source.Describe("<other/>");

        Assert.That(received.Select(message => ((StringMessage)message.Content).Data), Is.EqualTo(new[] { "<robot/>", "<other/>" }));
    }

    static JointTrajectoryMessage Plan(double position, string joint) =>
        new(Gateways.Start, [joint], [new JointTrajectoryPoint(TimeSpan.Zero, [position])]);

    List<string> PlansOfLateSubscriber()
    {
        var received = new List<string>();
        _hub.Subscribe(RosTopics.JointTrajectory, message => received.Add(Encoding.UTF8.GetString(message.Utf8(RosTimeForm.Sec).Span))).Dispose();
        return received;
    }

    [Test]
    public void Publish_SetPointsLongerThanAMessageWhenWritten_AreRefusedAndReserveNoJoint()
    {
        using var arm = _hub.OpenSource();
        using var other = _hub.OpenSource();
        JointTrajectoryMessage Path(int points) =>
            new(Gateways.Start, ["a"], [.. Enumerable.Range(0, points).Select(i => new JointTrajectoryPoint(TimeSpan.FromTicks(i), [0]))]);

        Assert.That(arm.Publish(Path(2000))?.Reason, Is.EqualTo(DropReason.TooLarge));
        Assert.That(PlansOfLateSubscriber(), Is.Empty);
        Assert.That(other.Publish(Path(500)), Is.Null);
        Assert.That(Encoding.UTF8.GetByteCount(PlansOfLateSubscriber().Single()), Is.LessThan(ProtocolLimits.MessageBytes));
    }

    [TestCase('a', 1)]
    [TestCase('ä', 0)]
    public void Publish_JointsWithLongNames_PublishesOnlyWhatFitsInOneMessage(char letter, int published)
    {
        using var source = _hub.OpenSource();
        var names = Enumerable.Range(0, 256).Select(i => FormattableString.Invariant($"{i:000}").PadRight(ProtocolLimits.NameLength, letter)).ToArray();

        var refusal = source.Publish(new JointStateMessage(Gateways.Start, names, new double[256]));

        Assert.That(refusal?.Reason, published == 1 ? Is.Null : Is.EqualTo(DropReason.TooLarge));
        Assert.That(_received.Count(message => message.Utf8(RosTimeForm.Sec).Length <= ProtocolLimits.MessageBytes), Is.EqualTo(published));
        Assert.That(_received, Has.Count.EqualTo(published));
    }

    [Test]
    public void Subscribe_AfterSetPoints_ReceivesTheNewestSetPointsOfEachSource()
    {
        using var arm = _hub.OpenSource();
        var gripper = _hub.OpenSource();
        arm.Publish(Plan(0.25, "a"));
        arm.Publish(Plan(0.5, "a"));
        gripper.Publish(Plan(0.75, "g"));

        Assert.That(PlansOfLateSubscriber(), Has.Count.EqualTo(2));
        Assert.That(PlansOfLateSubscriber(), Has.One.Contains("0.5").And.One.Contains("0.75").And.None.Contains("0.25"));

        gripper.Dispose();
        Assert.That(PlansOfLateSubscriber(), Has.Count.EqualTo(1), "a disposed source has no plans");
    }
}
