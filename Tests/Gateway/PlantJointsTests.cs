using Nowpose.Gateway.MotionRecordings;
using Nowpose.Gateway.Plants;
using Nowpose.Headless.Tests.Cli;
using Nowpose.Kinematics;
using Nowpose.Motion;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

public class PlantJointsTests
{
    static RobotModel Chain(int joints) => UrdfReader.Read(
        "<robot name=\"chain\"><link name=\"l0\"/>" + string.Concat(Enumerable.Range(1, joints).Select(i =>
            $"<link name=\"l{i}\"/><joint name=\"j{i}\" type=\"continuous\"><parent link=\"l{i - 1}\"/><child link=\"l{i}\"/></joint>"))
        + "</robot>",
        "chain.urdf");

    static RecordedMotion Recorded(RobotModel robot)
    {
        using var file = new TemporaryFile("t,j1\n0,0\n1,1\n");
        return new RecordedMotion(MotionRecording.Read(file.Path), robot);
    }

    [Test]
    public void Plants_MaximumNumberOfJoints_AreAccepted()
    {
        var robot = Chain(256);

        Assert.That(new PickAndPlaceMotion(robot).JointNames.Count, Is.EqualTo(256));
        Assert.That(Recorded(robot).JointNames.Count, Is.EqualTo(256));
    }

    [Test]
    public void Plants_TooManyJoints_ThrowsWithNumberAndMaximum()
    {
        var robot = Chain(257);

        foreach (var plant in new Func<RobotModel, IMotion>[] { robot => new PickAndPlaceMotion(robot), Recorded })
        {
            var error = Assert.Throws<InputException>(() => plant(robot));
            Assert.That(error.Message, Does.Contain("robot chain").And.Contain("257").And.Contain("256").And.Not.Contain("\n"));
        }
    }
}
