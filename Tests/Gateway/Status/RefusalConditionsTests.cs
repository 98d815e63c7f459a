using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Status.Events;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>Tests which refusals are conditions, and for how long.</summary>
public class RefusalConditionsTests
{
    readonly MessageHub _hub = new();
    readonly SteppedTime _time = new();
    RefusalConditions _conditions;

    [SetUp]
    public void SetUp() => _conditions = new RefusalConditions(_hub, _time);

    [TearDown]
    public void TearDown() => _conditions.Dispose();

    string[] Which() => [.. _conditions.Read().Select(one => one.Which)];

    HubSource Source(string name)
    {
        var source = _hub.OpenSource();
        source.Name = name;
        return source;
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
        var plan = new JointTrajectoryMessage(Gateways.Start, ["a"], [new JointTrajectoryPoint(TimeSpan.Zero, [1.0])]);
        Source("first").Publish(plan, robot: "arm1");
        Source("copy").Publish(plan, robot: "arm1");

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

    static void Refuse(HubSource source, string robot, DropReason reason) =>
        source.ReportRefused(robot, "a", new Refusal(reason, robot, Rule: DropMessages.Of(reason)));
}
