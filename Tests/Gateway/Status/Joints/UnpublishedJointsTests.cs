using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status.Joints;

/// <summary>Tests how joints of the described robot that no source publishes are found.</summary>
public class UnpublishedJointsTests
{
    [Test]
    public void Read_OneArmJointHasNoSourceButTheOthersDo_IsMissing()
    {
        var arm = RobotFiles.Load("youbot");
        var names = UnpublishedJoints.NamesOf(arm).Order().ToArray();
        RobotModel robot = null;
        var joints = new SampledBoard(() => robot);

        joints.Send(2, names[1..]);
        Assert.That(joints.Board.Read(), Has.All.Property("State").EqualTo(JointDataState.Live), "no robot is described");
        robot = arm;
        Assert.That(joints.Board.Read().Select(joint => joint.Name), Is.EqualTo(names[1..]), "the source of the joint may still be starting");
        joints.Send(UnpublishedJoints.StartTimeout.TotalSeconds + 0.1, names[1..]);

        var missing = joints.Joint(names[0]);
        Assert.That(missing.State, Is.EqualTo(JointDataState.Missing));
        Assert.That(missing.Source, Is.EqualTo("no source"));
        Assert.That(missing.Since, Is.EqualTo(joints.Time.GetUtcNow() - UnpublishedJoints.StartTimeout - TimeSpan.FromSeconds(0.1)));
        Assert.That(missing.Reason, Is.EqualTo(JointReasons.NotPublished));
        Assert.That(missing.ReasonWord, Is.EqualTo("not-published"));
        joints.Send(0.1, names);
        Assert.That(joints.Board.Read(), Has.Count.EqualTo(names.Length).And.All.Property("State").EqualTo(JointDataState.Live));
    }

    [Test]
    public void Read_NoJointOfTheArmHasASource_ContainsNoneOfThem()
    {
        var joints = new SampledBoard(() => RobotFiles.Load("youbot"));

        joints.Send(5, "another_robots_joint");

        Assert.That(joints.Board.Read().Select(joint => joint.Name), Is.EqualTo(new[] { "another_robots_joint" }), "no source publishes this robot");
    }

    [Test]
    public void NamesOf_MimicJointInTheArm_ContainsItsMasterJointOnce()
    {
        var robot = UrdfReader.Read(
            "<robot name=\"r\"><link name=\"l0\"/><link name=\"l1\"/><link name=\"l2\"/>" +
            "<joint name=\"a\" type=\"continuous\"><parent link=\"l0\"/><child link=\"l1\"/></joint>" +
            "<joint name=\"b\" type=\"continuous\"><parent link=\"l1\"/><child link=\"l2\"/><mimic joint=\"a\"/></joint></robot>",
            "r.urdf");

        Assert.That(UnpublishedJoints.NamesOf(robot), Is.EqualTo(new[] { "a" }));
    }
}
