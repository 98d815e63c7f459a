using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Plants;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests which description of a robot the hub publishes if two sources send one.</summary>
public class SourceDescriptionTests
{
    const string Valid = "<robot name='a'><link name='base'/></robot>";

    MessageHub _hub;

    [SetUp]
    public void SetUp() => _hub = new MessageHub();

    // A source sends the description once, so it must not be lost if the source starts before the previous one has ended.
    [TestCase("")]
    [TestCase("arm1")]
    public void Publish_JointsTakenOverFromAnotherSource_TakesOverTheDescription(string robot)
    {
        var first = _hub.OpenSource();
        using var second = _hub.OpenSource();
        first.Describe("<old/>", robot);
        first.Publish(Gateways.State(1, "a"), robot: robot);
        Assert.That(second.Describe("<new/>", robot), Is.Not.Null);
        Assert.That(second.Publish(Gateways.State(2, "a"), robot: robot), Is.Not.Null);
        Assert.That(_hub.DescriptionOf(robot), Is.EqualTo("<old/>"));

        first.Dispose();
        Assert.That(second.Publish(Gateways.State(3, "a"), robot: robot), Is.Null);

        Assert.That(_hub.DescriptionOf(robot), Is.EqualTo("<new/>"));
    }

    [Test]
    public void Publish_JointsTakenOverWithAnInvalidDescription_KeepsTheValidDescription()
    {
        var first = _hub.OpenSource();
        using var second = _hub.OpenSource();
        first.Describe(Valid);
        Assert.That(second.Describe("not xml")?.Reason, Is.EqualTo(DropReason.JointTaken));

        first.Dispose();
        Assert.That(second.Publish(Gateways.State(1, "a")), Is.Null);

        Assert.That(_hub.DescriptionOf(""), Is.EqualTo(Valid));
    }

    // A refused joint is claimed with each message, and a parsed description takes more than 100 kB.
    [Test]
    public void Publish_JointAndDescriptionAreRefused_DoesNotParseTheDescriptionAgain()
    {
        using var first = _hub.OpenSource();
        using var second = _hub.OpenSource();
        var urdf = RobotFiles.LoadText("ur10e");
        first.Describe(urdf);
        first.Publish(Gateways.State(1, "a"));
        second.Describe(urdf.Replace("ur10e", "other", StringComparison.Ordinal));

        var allocated = AllocatedBytes(() => second.Publish(Gateways.State(1, "a", "b")));

        Assert.That(allocated, Is.LessThan(20_000));
    }

    [Test]
    public void Describe_SameTextAgain_IsNotParsedAgain()
    {
        using var source = _hub.OpenSource();
        var urdf = RobotFiles.LoadText("ur10e");
        source.Describe(urdf);

        Assert.That(AllocatedBytes(() => source.Describe(urdf)), Is.LessThan(100_000));
    }

    [Test]
    public void Describe_InvalidFromAnotherSource_DoesNotReserveTheRobot()
    {
        var first = _hub.OpenSource();
        first.Describe(RobotFiles.LoadText("ur5"));
        first.Dispose();
        using var tool = _hub.OpenSource();
        using var plant = _hub.OpenSource();
        var urdf = RobotFiles.LoadText("ur10e");

        Assert.That(tool.Describe("not xml")?.Reason, Is.EqualTo(DropReason.NotUrdf));
        Assert.That(plant.Describe(urdf), Is.Null);

        Assert.That(_hub.DescriptionOf(""), Is.EqualTo(urdf));
    }

    [Test]
    public void Publish_DescriptionWithdrawnBeforeTheTakeover_KeepsTheEarlierDescription()
    {
        var first = _hub.OpenSource();
        using var second = _hub.OpenSource();
        first.Describe("<old/>");
        second.Describe("<new/>");

        second.Release(RosTopics.RobotDescription);
        first.Dispose();
        second.Publish(Gateways.State(1, "a"));

        Assert.That(_hub.DescriptionOf(""), Is.EqualTo("<old/>"));
    }

    // Returns the bytes that an action allocates when it is repeated.
    static long AllocatedBytes(Action action)
    {
        action();
        const int Rounds = 10;
        var before = GC.GetAllocatedBytesForCurrentThread();
        for (var i = 0; i < Rounds; i++) action();
        return (GC.GetAllocatedBytesForCurrentThread() - before) / Rounds;
    }
}
