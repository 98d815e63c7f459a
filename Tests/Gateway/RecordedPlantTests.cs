using Nowpose.Gateway.Messages;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Gateway.Plants;
using Nowpose.Headless.Tests.Cli;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

public class RecordedPlantTests
{
    const string Rows = "0,0.1,0.2\n1,0.3,0.6\n3,0.5,0.4\n";

    static RecordedMotion Played(string header, string robot)
    {
        using var file = new TemporaryFile(header + "\n" + Rows);
        return new RecordedMotion(MotionRecording.Read(file.Path), RobotFiles.Load(robot));
    }

    static double[] At(RecordedMotion motion, double seconds)
    {
        var positions = new double[motion.JointNames.Count];
        motion.At(seconds, positions);
        return positions;
    }

    [Test]
    public void At_ColumnsNamedLikeJoints_MovesThoseJoints()
    {
        var motion = Played("t,wrist_3_joint,elbow_joint", "ur5");

        Assert.That(At(motion, 1), Is.EqualTo(new[] { 0, 0, 0.6, 0, 0, 0.3 }));
        Assert.That(motion.Warning, Is.Null);
    }

    [Test]
    public void At_ColumnsWithOtherNames_MovesTheJointsInOrder()
    {
        var motion = Played("t,q1,q2", "ur5");

        Assert.That(At(motion, 0.5), Is.EqualTo(new[] { 0.2, 0.4, 0, 0, 0, 0 }).Within(1e-12));
        Assert.That(motion.Warning, Does.EndWith(PlantMessages.ColumnsInOrder("", "ur5", "q1 moves shoulder_pan_joint, q2 moves shoulder_lift_joint")));
    }

    [Test]
    public void RecordedMotion_OneOfTheColumnsIsNoJoint_ThrowsWithFileAndColumn()
    {
        using var file = new TemporaryFile("t,wrist_3_joint,elbow_jiont\n" + Rows);

        var error = Assert.Throws<InputException>(() => new RecordedMotion(MotionRecording.Read(file.Path), RobotFiles.Load("ur5")));

        Assert.That(error.Message, Does.StartWith(file.Path + ":").And.Contain(" elbow_jiont,").And.Contain("elbow_joint"));
    }

    [Test]
    public void Read_Session_ThrowsWithTheFile() =>
        Assert.That(
            () => MotionRecording.Read("session.jsonl"), Throws.TypeOf<InputException>().With.Message.EqualTo(MotionFileMessages.Session("session.jsonl")));

    // A robot may have as many joints as a rigid body has columns.
    [Test]
    public void RecordedMotion_RigidBody_Throws()
    {
        using var file = new TemporaryFile("t_s,x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n1,0,0,1,0,0,0,1\n");
        var robot = Nowpose.Kinematics.UrdfReader.Read(
            "<robot name='seven'><link name='l0'/>" + string.Concat(Enumerable.Range(1, 7).Select(i =>
                $"<link name='l{i}'/><joint name='j{i}' type='continuous'><parent link='l{i - 1}'/><child link='l{i}'/><axis xyz='0 0 1'/></joint>"))
            + "</robot>", "seven");
        var recording = MotionRecording.Read(file.Path);

        Assert.That(() => new RecordedMotion(recording, robot), Throws.TypeOf<InputException>().With.Message.StartsWith(file.Path + ":"));
    }

    [TestCase(0, 0.1)]
    [TestCase(-1, 0.1)]
    [TestCase(3, 0.5)]
    [TestCase(5, 0.3)]
    [TestCase(6, 0.1)]
    [TestCase(6 + 5, 0.3)]
    public void At_AnyTime_PlaysForwardThenBackward(double seconds, double expected)
    {
        var motion = Played("t,q1,q2", "ur5");

        Assert.That(motion.CycleSeconds, Is.EqualTo(6));
        Assert.That(At(motion, seconds)[0], Is.EqualTo(expected).Within(1e-12));
    }

    [Test]
    public void At_ColumnOfAFinger_MovesItsMimicJoint()
    {
        var motion = Played("t,gripper_finger_joint_l,arm_joint_1", "youbot");

        Assert.That(At(motion, 1)[^2..], Is.EqualTo(new[] { 0.3, 0.3 }));
    }

    [Test]
    public void Constructor_MoreColumnsThanJoints_ThrowsWithBothNumbers()
    {
        using var file = new TemporaryFile("t,a,b,c,d,e,f,g\n0,1,1,1,1,1,1,1\n1,1,1,1,1,1,1,1\n");

        var error = Assert.Throws<InputException>(() => new RecordedMotion(MotionRecording.Read(file.Path), RobotFiles.Load("ur5")));

        Assert.That(error.Message, Does.Contain("7 columns").And.Contain("6 joints").And.Not.Contain("\n"));
    }
}
