using Nowpose.Cli.Demo;
using Nowpose.Cli.Demo.Virtual;
using Nowpose.Simulation.Work;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Demo;

/// <summary>Tests the errors of the cell's objects in a demo in virtual time.</summary>
public class BodiesInDemoTests
{
    static DemoSettings Settings(int seed, string predictor = "adaptive") => VirtualDemo.Settings(20, "wifi", seed, predictor);

    [TestCase(1)]
    [TestCase(2)]
    [TestCase(3)]
    public void Objects_Moving_AreShownAtTheirTruePoses(int seed)
    {
        var bodies = new DemoScore(VirtualStage.Play(Settings(seed), hasScene: false)).Result().Bodies;

        Assert.That(bodies.ErrorMm.Reduction, Is.GreaterThan(0.85));
        Assert.That(bodies.ErrorMm.Rms, Is.LessThan(3));
        Assert.That(bodies.ErrorDeg.Reduction, Is.GreaterThan(0.85));
        Assert.That(bodies.ErrorDeg.Rms, Is.LessThan(1));
        Assert.That(bodies.LargestSlipMm, Is.LessThan(0.1), "a gripped object stays in the gripper");
    }

    // Fast arms, whose predicted pose is several millimetres wrong until samples at rest have arrived.
    [TestCase("ur5", "wifi", 1)]
    [TestCase("ur5", "wifi", 2)]
    [TestCase("ur5", "wifi", 3)]
    [TestCase("ur5", "lan", 1)]
    [TestCase("ur5", "busy-wifi", 1)]
    [TestCase("ur10e", "wifi", 1)]
    public void Objects_GrippedByAFastArm_StayInTheGripper(string robot, string network, int seed)
    {
        var bodies = new DemoScore(VirtualStage.Play(VirtualDemo.Settings(20, network, seed, name: robot), hasScene: false)).Result().Bodies;

        Assert.That(bodies.LargestSlipMm, Is.LessThan(0.1));
        Assert.That(bodies.ErrorMm.Reduction, Is.GreaterThan(0.85));
        Assert.That(bodies.ErrorDeg.Rms, Is.LessThan(1));
    }

    [Test]
    public void Objects_WithoutCompensation_HaveTheErrorOfHold()
    {
        var bodies = new DemoScore(VirtualStage.Play(Settings(1, "hold"), hasScene: false)).Result().Bodies;

        Assert.That(bodies.ErrorMm.Reduction, Is.EqualTo(0).Within(0.02));
        Assert.That(bodies.ErrorMm.HoldRms, Is.GreaterThan(15));
    }

    [Test]
    public void Slip_MovingGripperWithoutItsObjectAsDisplayed_IsTheDistanceOfTheObjectFromTheGripper()
    {
        var run = VirtualStage.Play(Settings(1) with { Seconds = 12 }, hasScene: false);
        var work = run.Settings.Motion.Work;
        var late = new DemoBodies(work);
        for (var frame = 0; frame < run.Frames.Rows.Count; frame++)
            for (var body = 0; body < work.Names.Count; body++)
            {
                var shown = run.Bodies.At(frame, body);
                late.Add(shown.Parent != work.Robots[0].Tool ? shown : shown with { Parent = CellWork.Conveyor, Displayed = work.Robots[0].Taken });
            }

        var bodies = new DemoScore(run with { Bodies = late }).Result().Bodies;

        Assert.That(bodies.LargestSlipMm, Is.GreaterThan(50), "the object remains on the conveyor");
    }

    [Test]
    public void Result_CellWithoutObjects_HasNoObjectResults() => Assert.That(
        new DemoScore(VirtualStage.Play(VirtualDemo.Settings(6, "wifi", 1, hasWork: false), hasScene: false)).Result().Bodies, Is.Null);
}
