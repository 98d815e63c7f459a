using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Status;
using Nowpose.Messages;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class LimitAlarmTests
{
    static readonly string[] Joints = ["shoulder_pan_joint", "elbow_joint"];

    MessageHub _hub;
    HubSource _source;
    List<string> _lines;
    LimitAlarm _alarm;

    [SetUp]
    public void Open()
    {
        _hub = new MessageHub();
        _source = _hub.OpenSource();
        _lines = [];
        _alarm = new LimitAlarm(_hub, _lines.Add);
    }

    void Send(double elbow) => _source.Publish(new JointStateMessage(ControlTime.FromSeconds(1), Joints, [0.5, elbow]));

    // Publishes until the position is found outside its limits, because another thread reads the description first.
    Task Found(double elbow) => Soon.BecomesAsync(
        () =>
        {
            Send(elbow);
            return _alarm.Joints.Count > 0;
        },
        "the joint is found");

    [Test]
    public async Task Joints_OnePositionInDegrees_IsLoggedOnceAndCounted()
    {
        _source.Describe(RobotFiles.LoadText("ur5"));

        await Found(90);
        for (var i = 0; i < 200; i++) Send(90);
        _source.Describe(RobotFiles.LoadText("ur5"));
        for (var i = 0; i < 200; i++) Send(90);

        Assert.That(_alarm.Joints, Is.EqualTo(new[] { "elbow_joint" }));
        Assert.That(_lines, Has.Count.EqualTo(1));
        Assert.That(_lines[0], Is.EqualTo(RobotMessages.BeyondLimits("elbow_joint", 90, "rad", -2 * Math.PI, 2 * Math.PI, "degrees")));
    }

    [TestCase(1.7e298)]
    [TestCase(-1.7e298)]
    public async Task Joints_HugePosition_IsLoggedWithFewDigits(double position)
    {
        _source.Describe(RobotFiles.LoadText("ur5"));

        await Found(position);

        Assert.That(_lines[0], Does.Contain("1.7E+298").And.Length.LessThan(300));
        Assert.That(EventTexts.BeyondLimits(position, "rad", -1, 1), Has.Length.LessThan(100));
    }

    [Test]
    public async Task Joints_RobotsWithNamespaces_AreCheckedAgainstTheirOwnLimits()
    {
        _source.Describe(RobotFiles.LoadText("ur5"));
        _source.Describe(RobotFiles.LoadText("ur5").Replace("6.283185307179586", "12.6", StringComparison.Ordinal), "arm1");
        _source.Describe(RobotFiles.LoadText("ur5"), "arm2");

        await Soon.BecomesAsync(
            () =>
            {
                Send(0.5);
                foreach (var robot in new[] { "arm1", "arm2" })
                    _source.Publish(new JointStateMessage(ControlTime.FromSeconds(1), Joints, [0.5, 7]), robot: robot);
                return _alarm.Joints.Count > 0 && _alarm.Robots.Count == 3;
            },
            "the joint is found");

        Assert.That(_alarm.Joints, Is.EqualTo(new[] { "arm2/elbow_joint" }));
        Assert.That(_lines, Is.EqualTo(new[] { RobotMessages.OfRobot("arm2", _alarm.Beyond[0].Found.Words) }));
    }

    [Test]
    public async Task Joints_RobotThatTheGatewayHasRemoved_AreNoLongerBeyondTheirLimits()
    {
        var ended = _hub.OpenSource();
        var names = Enumerable.Range(0, ProtocolLimits.Robots).Select(i => $"arm{i}").ToArray();
        foreach (var name in names) ended.Describe(RobotFiles.LoadText("ur5"), name);
        await Soon.BecomesAsync(
            () =>
            {
                ended.Publish(new JointStateMessage(ControlTime.FromSeconds(1), Joints, [0.5, 7]), robot: "arm0");
                return _alarm.Joints.Count == 1 && _alarm.Robots.Count == names.Length;
            },
            "the joint is found");

        ended.Dispose();
        _source.Publish(new JointStateMessage(ControlTime.FromSeconds(1), Joints, [0.5, 0.5]), robot: "new");

        Assert.That((_hub.Robots.Contains("arm0"), _hub.Robots.Contains("new")), Is.EqualTo((false, true)));
        Assert.That(_alarm.Joints, Is.Empty);
        Assert.That(_alarm.Robots.Select(robot => robot.Namespace), Is.EquivalentTo(names.Skip(1)));
    }

    [Test]
    public async Task Joints_NewDescription_AreCheckedAgainstItsLimits()
    {
        var urdf = RobotFiles.LoadText("ur5");
        _source.Describe(urdf);
        await Found(7);

        _source.Describe(urdf.Replace("6.283185307179586", "12.6", StringComparison.Ordinal));

        await Soon.BecomesAsync(
            () =>
            {
                Send(7);
                return _alarm.Joints.Count == 0;
            },
            "no joint is outside its limits now");
    }

    [Test]
    public async Task Invalid_DescriptionOfARobot_HasTheFaultUntilAValidDescription()
    {
        _source.Describe("<robot><link name=\"a\"/>", "arm1");
        _source.Describe(RobotFiles.LoadText("ur5"), "arm2");

        await Soon.BecomesAsync(() => _alarm.Invalid.Count == 1, "the description is read");
        Assert.That(_alarm.Invalid[0].Namespace, Is.EqualTo("arm1"));
        Assert.That(_alarm.Invalid[0].Fault, Does.StartWith(RobotTopic.NameOf("arm1", RosTopics.RobotDescription) + ":1: "));
        _source.Describe(RobotFiles.LoadText("ur5"), "arm1");

        await Soon.BecomesAsync(() => _alarm.Invalid.Count == 0, "the valid description is read");
    }

    [Test]
    public void Joints_NoValidDescription_AreNotChecked()
    {
        for (var i = 0; i < 10; i++) Send(90);
        _source.Describe("no robot");
        for (var i = 0; i < 10; i++) Send(90);

        Assert.That(_alarm.Joints, Is.Empty);
        Assert.That(_lines, Is.Empty);
    }
}
