using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Session;

[NonParallelizable] // measures allocations
public class ForwardKinematicsAllocationTests
{
    [Test]
    public void ForwardKinematics_SecondFrame_AllocatesNothing()
    {
        var model = RobotFiles.Load("youbot");
        var kinematics = new ForwardKinematics(model);
        var positions = new double[model.MovingJoints.Count];
        var given = new bool[positions.Length];
        var poses = new RigidTransform[model.Links.Count];
        Frame(1);

        var before = GC.GetAllocatedBytesForCurrentThread();
        for (var i = 0; i < 1000; i++) Frame(i);
        var allocated = GC.GetAllocatedBytesForCurrentThread() - before;

        Assert.That(allocated, Is.Zero);

        void Frame(int i)
        {
            positions[0] = 0.001 * i;
            model.CompleteMimics(positions, given);
            kinematics.Compute(positions, poses);
            UnityFrame.ToUnity(poses[^1]);
        }
    }
}
