using Nowpose.Gateway.Plants;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using NUnit.Framework;

namespace Nowpose.Unity.Tests;

/// <summary>Tests rigs that display the same robot of a session.</summary>
public class SameRobotTests : PlayedParts
{
    // A further robot without its namespace would display the motion of the first robot as its own.
    [Test]
    public void Rigs_DisplayTheSameRobot_SecondOneIsReported()
    {
        var first = Below<RobotRig>("Robot", _session.transform);
        var second = Below<RobotRig>("Robot 2", _session.transform);
        Run(2);

        Assert.That(FaultsNow(), Is.EqualTo("robot Robot 2: " + RigMessages.SameRobot("Robot")));
        Assert.That((first.Fault, second.Fault), Is.EqualTo(((string)null, RigMessages.SameRobot("Robot"))));
        Assert.That(_cell.Messages, Has.Exactly(1).Contains(RigMessages.SameRobot("Robot")));
        Assert.That(_cell.AllocatedIn(() => _cell.Run(1, _session, _session.Parts.Update)), Is.Zero);

        first.gameObject.SetActive(false);
        Run(0.1);
        Assert.That((FaultsNow(), second.Fault), Is.EqualTo(("", (string)null)));

        first.gameObject.SetActive(true);
        Run(0.1);
        Assert.That(FaultsNow(), Is.EqualTo("robot Robot: " + RigMessages.SameRobot("Robot 2")), "the rig that was enabled later");
    }

    // The settings give the session's own robot a namespace, so a rig with it and a rig without one show the same robot.
    [TestCase("arm1", "")]
    [TestCase("", "arm1")]
    public void Rigs_NamespaceOfTheSettingsAndNone_SecondOneIsReported(string firstName, string secondName)
    {
        UseNamespace("arm1");
        var youbot = RobotDescriptionAsset.Create("youbot", RobotFiles.LoadText("youbot"));
        // The rig that was added later is higher in the hierarchy, and therefore moves first.
        var first = Below<RobotRig>("Robot", Below<FrameProbe>("group", _session.transform).transform);
        first.Follow(null, firstName, youbot);
        var second = Below<RobotRig>("Robot 2", _session.transform);
        second.Follow(null, secondName, youbot);
        Run(2);

        Assert.That(second.Fault, Is.EqualTo(RigMessages.SameRobot("Robot")));
        Assert.That(first.Fault, Is.Not.EqualTo(RigMessages.SameRobot("Robot 2")));
        Assert.That(FaultsNow(), Does.Contain($"{RigMessages.SameRobot("Robot")}"));
        Assert.That(_cell.Messages, Has.Exactly(1).Contains(RigMessages.SameRobot("Robot")));
    }

    [Test]
    public void Rig_NamespaceOfTheSettingsDisabled_MainRobotCountsForTheStateOfTheCell()
    {
        UseNamespace("arm1");
        var rig = Below<RobotRig>("Robot", _session.transform);
        rig.Follow(null, "arm1", RobotDescriptionAsset.Create("youbot", RobotFiles.LoadText("youbot")));
        Run(1);

        rig.gameObject.SetActive(false);
        Run(0.1);

        Assert.That(_session.Session.Robots[0].IsShown);
    }

    void UseNamespace(string name) => _session.Settings = new SessionSettings(
        PlayedCell.Offline.Connection, PlayedCell.Offline.Visualisation, PlayedCell.Offline.Prediction, robotNamespace: name);

    [Test]
    public void Rigs_OfSeveralRobotsOrHeldPoses_AreNotReported()
    {
        Below<RobotRig>("Robot", _session.transform);
        Below<RobotRig>("Added", _session.transform).Follow(null, "arm3", RobotDescriptionAsset.Create("third", RobotFiles.LoadText("youbot")));
        Below<RobotRig>("Ghost", _session.transform).Follow(null, shows: RigPose.Held);
        Second(RobotFiles.LoadText("youbot"));
        Run(1);

        Assert.That(_cell.Messages, Has.None.Matches(RigMessages.SameRobot(".*")));
    }
}
