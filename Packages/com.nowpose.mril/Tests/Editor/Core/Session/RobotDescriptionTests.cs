using System;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Tests.Core.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>Tests how a session uses the gateway's robot description.</summary>
    public class RobotDescriptionTests
    {
        CompensationSession _session;

        [SetUp]
        public void Start() => _session = new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.FromMilliseconds(40))),
            UrdfFiles.Robot("youbot"), new StopwatchHeadsetClock());

        [TearDown]
        public void Stop() => _session.Dispose();

        RobotDescriptionMatch Shown => _session.Statistics(default).RobotDescriptionMatch;

        [Test]
        public void Described_NoDescription_IsUnknown()
        {
            Assert.That(_session.RobotDescription, Is.Null);
            Assert.That(_session.DescribedRobot, Is.Null);
            Assert.That(_session.RobotDescriptionMatch, Is.EqualTo(RobotDescriptionMatch.Unknown));
            Assert.That(Shown, Is.EqualTo(RobotDescriptionMatch.Unknown));
        }

        [Test]
        public void Described_UrdfOfTheRobot_MatchIsSame()
        {
            var text = UrdfFiles.Text("youbot.urdf").Replace("\r\n", "\n").Replace("\n", "\r\n") + "\n";

            _session.Described(text);

            Assert.That(_session.RobotDescription, Is.EqualTo(text));
            Assert.That(_session.RobotDescriptionMatch, Is.EqualTo(RobotDescriptionMatch.Same));
            Assert.That(Shown, Is.EqualTo(RobotDescriptionMatch.Same));
            Assert.That(_session.Drops.Total, Is.EqualTo(0));
        }

        [Test]
        public void Described_AnotherRobot_MatchIsDifferentAndTheRobotIsRead()
        {
            _session.Described(UrdfFiles.Text("ur5.urdf"));

            Assert.That(Shown, Is.EqualTo(RobotDescriptionMatch.Different));
            Assert.That(_session.DescribedRobot.IndexOfMovingJoint("shoulder_pan_joint"), Is.GreaterThanOrEqualTo(0));
            Assert.That(_session.Robot.IndexOfMovingJoint("arm_joint_1"), Is.GreaterThanOrEqualTo(0), "the displayed robot does not change");
        }

        [Test]
        public void Described_Twice_UsesTheNewest()
        {
            _session.Described(UrdfFiles.Text("ur5.urdf"));
            _session.Described(UrdfFiles.Text("youbot.urdf"));

            Assert.That(Shown, Is.EqualTo(RobotDescriptionMatch.Same));
        }

        [TestCase("")]
        [TestCase("hello")]
        [TestCase("<robot name='r'/>")]
        [TestCase("<sdf/>")]
        [TestCase("<robot name='r'><link name='a'/>")]
        [TestCase("<!DOCTYPE r [<!ENTITY a 'aaaaaaaaaa'>]><robot name='&a;'><link name='a'/></robot>")]
        [TestCase("<robot name='r'><link name='a'/><link name='b'/></robot>")]
        public void Described_NotAUrdf_IsCountedAndIgnored(string text)
        {
            _session.Described(UrdfFiles.Text("youbot.urdf"));
            var before = _session.RobotDescription;

            _session.Described(text);

            Assert.That(_session.Drops[DropReason.NotUrdf], Is.EqualTo(1));
            Assert.That(_session.Drops.Total, Is.EqualTo(1));
            Assert.That(_session.RobotDescription, Is.SameAs(before));
            Assert.That(Shown, Is.EqualTo(RobotDescriptionMatch.Same));
            Assert.That(_session.RobotDescriptionFault, Does.StartWith("/robot_description").And.Not.Contains("\n"));
            _session.Described(UrdfFiles.Text("youbot.urdf"));
            Assert.That(_session.RobotDescriptionFault, Is.Null);
        }

        [Test]
        public void Described_SameTextAgain_IsNotReadAgain()
        {
            var text = UrdfFiles.Text("youbot.urdf");
            _session.Described(text);
            var before = _session.DescribedRobot;

            _session.Described(new string(text.ToCharArray()));

            Assert.That(_session.DescribedRobot, Is.SameAs(before));
        }
    }
}
