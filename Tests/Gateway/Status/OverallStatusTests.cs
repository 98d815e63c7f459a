using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Status;
using Nowpose.Gateway.Status.Events;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>Tests the overall status in cells with and without a robot.</summary>
public class OverallStatusTests
{
    static FrameView Frame(string state) => new("part", "world", "twin", state, null);

    static SignalView Signal(string state) => new("closed", 1, "twin", state, null);

    static string LevelOf(FrameView[] frames, SignalView[] signals, bool hasRobot = false) =>
        OverallStatus.Of([], [], frames, signals, hasRobot, headsets: 1).Level;

    [Test]
    public void Of_NothingPublished_IsAWarning([Values] bool hasRobot) => Assert.That(LevelOf([], [], hasRobot), Is.EqualTo("warning"));

    [Test]
    public void Of_ObjectsOrSignalsInACellWithoutRobot_IsOk()
    {
        Assert.That(LevelOf([Frame("live")], []), Is.EqualTo("ok"));
        Assert.That(LevelOf([], [Signal("live")]), Is.EqualTo("ok"));
        Assert.That(LevelOf([Frame("live"), Frame("stationary")], [Signal("live")]), Is.EqualTo("ok"));
    }

    [Test]
    public void Of_ObjectsButNoJointsInACellWithARobot_IsAWarning() =>
        Assert.That(LevelOf([Frame("live")], [Signal("live")], hasRobot: true), Is.EqualTo("warning"));

    [Test]
    public void Of_StationaryObjectsOnly_IsAWarning() => Assert.That(LevelOf([Frame("stationary")], []), Is.EqualTo("warning"));

    [TestCase("stale", "live")]
    [TestCase("orphan", "live")]
    [TestCase("fault", "live")]
    [TestCase("live", "ended")]
    [TestCase("live", "missing")]
    public void Of_ObjectOrSignalNotCurrent_IsAWarning(string frame, string signal) =>
        Assert.That(LevelOf([Frame("live"), Frame(frame)], [Signal(signal)]), Is.EqualTo("warning"));

    [Test]
    public void Of_ObjectsNotCurrent_NamesThemWithTheirStates()
    {
        FrameView[] frames = [Frame("live"), Frame("orphan") with { Name = "lid" }, Frame("stale") with { Name = "box" }];

        var text = OverallStatus.Of([], [], frames, [Signal("ended"), Signal("fault")], hasRobot: false, headsets: 0).Text;

        Assert.That(text, Does.Match(@"^4 .*\b5 .*: lid \(orphan\), box \(stale\), closed \(ended\), …$"));
    }

    [Test]
    public void Of_JointsLive_IsOk()
    {
        var joint = new JointSnapshot("a", "plc", JointDataState.Live, default, null, 20, "");

        Assert.That(OverallStatus.Of([], [joint], [Frame("stale")], [], hasRobot: true, headsets: 0).Level, Is.EqualTo("ok"));
    }

    [Test]
    public void Of_SeveralConditions_IsTheMostSevere()
    {
        var condition = new Condition("frame", "part (twin)", "is in fault", "no value", Level.Error);

        Assert.That(OverallStatus.Of([condition], [], [Frame("fault")], [], hasRobot: false, headsets: 0).Level, Is.EqualTo("error"));
    }

    [Test]
    public void ExpectsJoints_AllPlantsWithObjectsOnly_IsFalse()
    {
        var objects = new PlantFile("twin.yaml", "twin", "") { HasObjects = true };
        var clock = new PlantFile("clock.yaml", "clock", "");

        Assert.That(PlantFile.ExpectsJoints([], "<robot/>"), Is.False, "without plants, sources of joints may connect at any time");
        Assert.That(PlantFile.ExpectsJoints([objects], null), Is.False);
        Assert.That(PlantFile.ExpectsJoints([objects, clock], null), Is.False);
        Assert.That(PlantFile.ExpectsJoints([clock], null));
        Assert.That(PlantFile.ExpectsJoints([objects], "<robot/>"));
        Assert.That(PlantFile.ExpectsJoints([objects with { Joints = ["a"] }], null));
        Assert.That(PlantFile.ExpectsJoints([objects with { PassesUnlisted = true }], null));
        Assert.That(PlantFile.ExpectsJoints([objects, clock with { Robot = "<robot/>" }], null));
        Assert.That(PlantFile.ExpectsJoints([objects, clock with { Robots = new Dictionary<string, string> { ["arm"] = "<robot/>" } }], null));
    }
}
