using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Status.Events;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>Tests which refusals are conditions, and for how long.</summary>
public class RefusalConditionsTests
{
    const string Valid = "<robot name='a'><link name='base'/></robot>";

    MessageHub _hub;
    SteppedTime _time;
    RefusalConditions _conditions;

    [SetUp]
    public void SetUp()
    {
        (_hub, _time) = (new MessageHub(), new SteppedTime());
        _conditions = new RefusalConditions(_hub, _time);
        foreach (var topic in new[] { RosTopics.JointTrajectory, RosTopics.RobotDescription })
        {
            _hub.Subscribe(topic, _conditions.Accept);
            _hub.SubscribeToRobots(topic, _conditions.Accept);
        }
    }

    string[] Which() => [.. _conditions.Read().Select(one => one.Which)];

    HubSource Source(string name)
    {
        var source = _hub.OpenSource();
        source.Name = name;
        return source;
    }

    [Test]
    public void MessageRate_Exceeded_IsAConditionFor5SecondsWithTheMaximumAndTheRemedy()
    {
        var rule = DropMessages.TooManyMessages(250);
        Source("hasty").ReportBrokenRule(EventTexts.ExceedsRate, rule);

        _time.Advance(TimeSpan.FromSeconds(4));
        var found = _conditions.Read().Single();
        Assert.That((found.Kind, found.Which, found.What, found.Reason), Is.EqualTo(("source", "hasty", EventTexts.ExceedsRate, rule)));
        _time.Advance(TimeSpan.FromSeconds(2));
        Assert.That(_conditions.Read(), Is.Empty);
    }

    [Test]
    public void MessageRate_ExceededByManyClients_HasABoundedNumberOfConditions()
    {
        for (var client = 0; client < 1000; client++) Source($"client{client}").ReportBrokenRule(EventTexts.ExceedsRate, "");

        Assert.That(Which(), Has.Length.EqualTo(64));
    }

    [Test]
    public void SetPoints_OfManyClientsThatMayNotPublish_DoNotHideAConflictOfSources()
    {
        for (var client = 0; client < 4; client++)
        {
            var observer = Source($"observer{client}");
            for (var robot = 0; robot < 16; robot++) Refuse(observer, $"r{client}x{robot}", DropReason.NotAllowed);
        }

        Assert.That(Which(), Has.Length.EqualTo(64));
        Source("first").Publish(Plan("a"), robot: "arm1");
        Source("copy").Publish(Plan("a"), robot: "arm1");

        var conflict = EventTexts.SourceOf("copy", EventTexts.SetPointsOf("arm1"));
        Assert.That(Which(), Has.Length.EqualTo(64).And.Contains(conflict));
        _time.Advance(TimeSpan.FromSeconds(6));
        Assert.That(Which(), Is.EqualTo(new[] { conflict }));
    }

    [Test]
    public void SetPoints_OfAClientThatMayNotPublish_DoNotReplaceOthers()
    {
        for (var client = 0; client < 4; client++)
        {
            var source = Source($"source{client}");
            for (var robot = 0; robot < 16; robot++) Refuse(source, $"r{client}x{robot}", DropReason.NotFinite);
        }

        Refuse(Source("observer"), "arm1", DropReason.NotAllowed);

        Assert.That(Which(), Has.Length.EqualTo(64).And.None.Contains("observer"));
    }

    [TestCase(DropReason.NotFinite, "Correct this, then send the set-points again.")]
    [TestCase(DropReason.Unsynchronised, "Send the set-points again.")]
    [TestCase(DropReason.NotAllowed, "")]
    public void SetPoints_Refused_RemedyDoesNotRepeatTheReason(DropReason reason, string remedy)
    {
        Refuse(Source("client"), "arm1", reason);

        Assert.That(_conditions.Read().Single().Remedy, Is.EqualTo(remedy));
    }

    // A source may send set-points only once per motion.
    [Test]
    public void SetPoints_RefusedSourceIsSilent_AreStillRefused()
    {
        Refuse(Source("client"), "arm1", DropReason.NotFinite);
        _time.Advance(TimeSpan.FromHours(1));

        Assert.That(Which(), Has.Length.EqualTo(1));
    }

    [TestCase("arm2", "a")]
    [TestCase("arm1", "b")]
    [TestCase("", "b")]
    public void SetPoints_SourceChangesToAnotherJointOrRobot_AreRefusedForTwoMoreMinutes(string robot, string joint)
    {
        HubSource owner = Source("owner"), client = Source("client");
        owner.Publish(Plan("c"), robot: "arm1");
        client.Publish(Plan("c"), robot: "arm1");
        Refuse(client, "arm1", DropReason.NotFinite);
        Refuse(Source("other"), "arm1", DropReason.NotFinite);

        // A pause does not count, because a source may send set-points only once per motion.
        _time.Advance(TimeSpan.FromMinutes(10));
        client.Publish(Plan(joint), robot: robot);
        _time.Advance(TimeSpan.FromMinutes(1));
        client.Publish(Plan(joint), robot: robot);
        _time.Advance(TimeSpan.FromMinutes(1) - TimeSpan.FromSeconds(1));
        Assert.That(Which(), Has.Length.EqualTo(3));
        _time.Advance(TimeSpan.FromSeconds(2));

        Assert.That(Which(), Is.EqualTo(new[] { EventTexts.SourceOf("other", EventTexts.SetPointsOf("arm1")) }));
    }

    // An arm and its gripper often have plans of their own.
    [Test]
    public void SetPoints_OfOneJointAreRefusedInEachCycle_AreOneConditionWithoutInterruption()
    {
        var client = Source("client");
        for (var cycle = 0; cycle < 5; cycle++)
        {
            Refuse(client, "arm1", DropReason.NotFinite);
            for (var motion = 0; motion < 3; motion++)
            {
                client.Publish(Plan("b"), robot: "arm1");
                _time.Advance(TimeSpan.FromSeconds(30));
                Assert.That(Which(), Has.Length.EqualTo(1));
            }
        }
    }

    // A source sends its description only once, and headsets keep the earlier one as long as it is invalid.
    [TestCase("")]
    [TestCase("arm1")]
    public void Description_InvalidAfterAValidOne_IsAConditionUntilItsSourceSendsAValidOne(string robot)
    {
        var client = Source("client");
        Describe(Source("former"), robot, Valid).Dispose();

        Describe(client, robot, "not xml");
        Describe(client, "arm2", Valid);
        _time.Advance(TimeSpan.FromHours(1));

        var found = _conditions.Read().Single();
        Assert.That((found.Kind, found.What, found.Level), Is.EqualTo(("description", EventTexts.IsRefused, Level.Error)));
        Assert.That(found.Which, Does.Contain(RobotTopic.NameOf(robot, RosTopics.RobotDescription)).And.Contain("client"));
        Assert.That(found.Reason, Does.Contain(RobotTopic.NameOf(robot, RosTopics.RobotDescription) + ":1"));
        Describe(client, robot, Valid);
        Assert.That(_conditions.Read(), Is.Empty);
    }

    // Headsets then show the robot with the description of the other source.
    [Test]
    public void Description_InvalidThenAnotherSourcePublishesAValidOne_IsNoCondition()
    {
        var client = Source("client");
        Describe(Source("former"), "arm1", Valid).Dispose();
        Describe(client, "arm1", "not xml");

        Describe(Source("other"), "arm1", Valid);
        Describe(client, "arm1", Valid);

        Assert.That(_conditions.Read(), Is.Empty);
    }

    [Test]
    public void Description_InvalidAndWithdrawn_IsNoCondition()
    {
        var client = Source("client");
        Describe(Source("former"), "arm1", Valid).Dispose();
        Describe(client, "arm1", "not xml");

        client.Release("/arm1" + RosTopics.RobotDescription);

        Assert.That(_conditions.Read(), Is.Empty);
    }

    // A source may connect only to send its description.
    [Test]
    public void Description_SourceOfAnInvalidOneHasEnded_IsAConditionFor5Seconds()
    {
        Describe(Source("former"), "", Valid).Dispose();
        Describe(Source("client"), "", "not xml").Dispose();

        _time.Advance(TimeSpan.FromSeconds(4));
        Assert.That(Which(), Has.Length.EqualTo(1));
        _time.Advance(TimeSpan.FromSeconds(2));
        Assert.That(Which(), Is.Empty);
    }

    // The description of a source that waits for its robot is examined when the source takes over the joints.
    [Test]
    public void Description_InvalidWhenTheSourceTakesOverTheJoints_IsACondition()
    {
        HubSource former = Source("former"), client = Source("client");
        Describe(former, "", Valid);
        Describe(client, "", "not xml");
        Assert.That(_conditions.Read(), Is.Empty);

        former.Dispose();
        client.Publish(Gateways.State(1, "a"));

        Assert.That(Which(), Has.Length.EqualTo(1));
    }

    static HubSource Describe(HubSource source, string robot, string urdf)
    {
        source.Describe(urdf, robot);
        return source;
    }

    [Test]
    public void Name_OfTwoClientsThatAreRefusedInTurn_IsOneCondition()
    {
        HubSource second = Source("second"), third = Source("third");
        for (var i = 0; i < 5; i++)
        {
            _hub.ReportNameRefused(second, "goggles");
            _hub.ReportNameRefused(third, "goggles");
            _time.Advance(TimeSpan.FromSeconds(1));
        }

        Assert.That(Which(), Is.EqualTo(new[] { "goggles" }));
    }

    static JointTrajectoryMessage Plan(string joint) => new(Gateways.Start, [joint], [new JointTrajectoryPoint(TimeSpan.Zero, [1.0])]);

    static void Refuse(HubSource source, string robot, DropReason reason) =>
        source.ReportRefused(robot, "a", new Refusal(reason, robot, Rule: DropMessages.Of(reason)));
}
