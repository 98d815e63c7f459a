using Nowpose.Gateway.Plants;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Session;

/// <summary>Tests the robot of a session, which comes from an asset or from the description that the gateway sends.</summary>
public class SessionRobotTests
{
    const string Positions = "[Nowpose] " + SessionMessages.FirstPositions;

    PlayedCell _cell;

    [SetUp]
    public void Start() => _cell = new PlayedCell();

    [TearDown]
    public void Stop() => _cell.Dispose();

    [Test]
    public void RobotAsset_Invalid_IsReportedWithItsName()
    {
        var session = _cell.NewSession();
        session.RobotAsset = RobotDescriptionAsset.Create("Broken", "<robot name='r'/>");

        session.gameObject.SetActive(true);

        Assert.That(session.Problem, Does.Contain("'Broken'"));
        Assert.That(session.Session, Is.Null);
    }

    [Test]
    public void Description_NoRobotAsset_BecomesTheRobot()
    {
        var session = _cell.Play(robot: null);
        var (changes, shown) = (0, 0);
        session.RobotChanged += () => changes++;
        session.Shown += _ => shown++;
        _cell.Run(1, session);
        Assert.That(session.Robot, Is.Null);
        Assert.That(session.Frame, Is.Null);
        Assert.That(shown, Is.EqualTo(0), "no frame is shown without a robot");

        session.Session.Described(RobotFiles.LoadText("ur5"));
        _cell.Run(5, session);

        Assert.That(session.Robot.Name, Is.EqualTo("ur5"));
        Assert.That(session.Session.Robot, Is.SameAs(session.Robot));
        Assert.That(changes, Is.EqualTo(1));
        Assert.That(session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(_cell.Messages.Count(m => m.Contains(SessionMessages.Description("ur5"))), Is.EqualTo(1));
    }

    [Test]
    public void Description_AfterAPause_IsTheSameRobotAgain()
    {
        var session = _cell.Play(robot: null);
        session.Session.Described(RobotFiles.LoadText("ur5"));
        _cell.Run(0.1, session);
        var robot = session.Robot;

        _cell.Player.Pause(true);
        _cell.Player.Pause(false);
        var resumed = session.Session;
        resumed.Described(RobotFiles.LoadText("ur5"));
        _cell.Run(0.1, session);

        Assert.That(session.Robot, Is.SameAs(robot));
        Assert.That(session.Session, Is.SameAs(resumed), "the same text does not restart the session");
        session.Session.Described(RobotFiles.LoadText("youbot"));
        _cell.Run(0.1, session);
        Assert.That(session.Robot.Name, Is.EqualTo("youbot"));
    }

    [TestCase(1, "", true)]
    [TestCase(2, "", false)]
    [TestCase(1, "arm2", false)]
    public void Description_AfterOtherSettings_IsKeptForTheSameGatewayAndNamespace(int webSocketPort, string robotNamespace, bool isKept)
    {
        var session = _cell.Play(robot: null);
        session.Session.Described(RobotFiles.LoadText("ur5"));
        _cell.Run(0.1, session);

        session.Settings = new SessionSettings(
            new ConnectionSettings("127.0.0.1", 1, webSocketPort, token: "new"), session.Settings.Visualisation, robotNamespace: robotNamespace);
        _cell.Run(0.1, session);

        Assert.That(session.Robot?.Name, Is.EqualTo(isKept ? "ur5" : null));
        session.Session.Described(RobotFiles.LoadText("youbot"));
        _cell.Run(0.1, session);
        Assert.That(session.Robot.Name, Is.EqualTo("youbot"));
    }

    [Test]
    public void Description_DiffersFromTheAsset_IsLoggedOnce()
    {
        var session = _cell.Play("youbot");
        for (var i = 0; i < 3; i++)
        {
            session.Session.Described(RobotFiles.LoadText("ur5"));
            _cell.Run(0.1, session);
            _cell.Player.Pause(true);
            _cell.Player.Pause(false);
        }

        Assert.That(session.Robot.Name, Is.EqualTo("youbot"));
        var warning = _cell.Player.Logs.Single(log => log.Message != Positions);
        Assert.That(warning.Type, Is.EqualTo(LogType.Warning));
        Assert.That(warning.Message, Does.Contain("'ur5'").And.Contain("'youbot'"));
    }

    [Test]
    public void Description_SameAsTheAsset_IsNotLogged()
    {
        var session = _cell.Play("youbot");

        session.Session.Described(RobotFiles.LoadText("youbot").Replace("\n", "\r\n"));
        _cell.Run(0.1, session);

        Assert.That(_cell.Messages.Where(message => message != Positions), Is.Empty);
    }

    [Test]
    public void Description_Invalid_IsLoggedOnce()
    {
        var session = _cell.Play(robot: null);

        for (var i = 0; i < 3; i++)
        {
            session.Session.Described("<robot name='r'>");
            _cell.Run(0.1, session);
        }

        Assert.That(session.Robot, Is.Null);
        Assert.That(_cell.Messages.Single(), Does.StartWith("[Nowpose] " + SessionMessages.DescriptionUnusable("/robot_description:")));
    }

    [Test]
    public void RobotAsset_Removed_UsesTheGatewaysRobot()
    {
        var session = _cell.Play("youbot");
        session.Session.Described(RobotFiles.LoadText("ur5"));
        _cell.Frame(session);

        session.RobotAsset = null;
        Assert.That(session.Robot, Is.Null);
        session.Session.Described(RobotFiles.LoadText("ur5"));
        _cell.Frame(session);

        Assert.That(session.Robot.Name, Is.EqualTo("ur5"));
    }
}
