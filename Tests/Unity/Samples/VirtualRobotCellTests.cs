using Nowpose.Network;
using Nowpose.Samples;
using Nowpose.Session;
using NUnit.Framework;
using UnityEngine;
using KnobRange = UnityEngine.RangeAttribute;
using static Nowpose.Unity.Tests.Samples.SampleErrors;

namespace Nowpose.Unity.Tests.Samples;

public class VirtualRobotCellTests
{
    [TestCase("youbot")]
    [TestCase("ur5")]
    public void Play_DefaultSettings_ErrorIsReduced(string robot)
    {
        using var sample = new PlayedSample(robot).Start().Run(6);

        sample.Run(20);

        Assert.That(sample.States, Is.Not.Empty.And.All.EqualTo(PoseState.Current));
        Assert.That(Rms(sample.HoldErrors), Is.GreaterThan(0.02), "there is a gap to close");
        Assert.That(1 - Rms(sample.Errors) / Rms(sample.HoldErrors), Is.GreaterThan(MinReduction));
        Assert.That(sample.Session.Statistics.ErrorReduction, Is.GreaterThan(MinReduction), "the panel shows it, too");
        Assert.That(Complaints(sample), Is.Empty);
    }

    [Test]
    public void Scene_Played_ErrorIsReduced()
    {
        using var sample = PlayedSample.OfScene().Run(6);

        sample.Run(20);

        Assert.That(sample.States, Is.All.EqualTo(PoseState.Current));
        Assert.That(Rms(sample.HoldErrors), Is.GreaterThan(0.02), "there is a gap to close");
        Assert.That(1 - Rms(sample.Errors) / Rms(sample.HoldErrors), Is.GreaterThan(MinReduction));
        Assert.That(sample.Session.Statistics.SampleLink.State, Is.EqualTo(LinkState.Idle), "the sample uses no network");
        Assert.That(Complaints(sample), Is.Empty);
    }

    // The manual's checklist moves these two objects in front of a headset.
    [Test]
    public void Scene_BaseAnchorAndRealRobotMoved_AllObjectsFollow()
    {
        using var sample = PlayedSample.OfScene().Run(6);
        var stationary = new[] { "conveyor", "fixture" }.Select(name => GameObject.Find(name).transform).ToArray();
        var before = stationary.Select(each => each.position).ToArray();
        var moved = new Vector3(0, -0.6f, 1.2f);

        sample.Cell.transform.Find("Base Anchor").position = moved;
        sample.Truth.transform.position = moved;
        sample.Run(20);

        Assert.That(1 - Rms(sample.Errors) / Rms(sample.HoldErrors), Is.GreaterThan(MinReduction));
        for (var i = 0; i < stationary.Length; i++)
            Assert.That(Vector3.Distance(stationary[i].position, before[i] + moved), Is.LessThan(1e-5), stationary[i].name);
    }

    [Test]
    public void Scene_Played_DrawsTheArmOnceAndTheGripperOnIt()
    {
        using var sample = PlayedSample.OfScene().Run(6);
        var gripper = sample.Displayed.GetComponentInChildren<VirtualGripper>();

        Assert.That(gripper.GetComponentsInChildren<MeshRenderer>(), Is.Not.Empty);
        Assert.That(sample.Displayed.GetComponentsInChildren<MeshRenderer>()
            .Where(drawn => drawn.enabled && !drawn.transform.IsChildOf(gripper.transform)), Is.Empty);
        Assert.That(sample.Truth.GetComponentsInChildren<MeshRenderer>(), Is.Not.Empty);
        Assert.That(sample.Held.GetComponentsInChildren<MeshRenderer>(), Is.Not.Empty);
    }

    [Test]
    public void Play_Twice_GivesTheSameResult()
    {
        using var one = new PlayedSample().Start().Run(8);
        var first = one.Displayed.Tool.position;
        using var two = new PlayedSample().Start().Run(8);

        Assert.That(two.Displayed.Tool.position, Is.EqualTo(first));
    }

    [Test]
    public void Play_SessionWithoutRobot_UsesTheRobotOfTheControlSystem()
    {
        using var sample = new PlayedSample(sessionKnowsTheRobot: false).Start().Run(8);

        Assert.That(sample.Session.Robot.IndexOfMovingJoint("arm_joint_1"), Is.GreaterThanOrEqualTo(0));
        Assert.That(sample.States[^1], Is.EqualTo(PoseState.Current));
        Assert.That(sample.Session.Session.RobotDescriptionMatch, Is.EqualTo(RobotDescriptionMatch.Same));
    }

    [Test]
    public void TruthRig_Playing_ShowsTheArmButNotTheTool()
    {
        using var sample = new PlayedSample().Start().Run(1);

        Assert.That(sample.Truth.Flange.GetComponentsInChildren<MeshRenderer>(), Has.Length.EqualTo(
            sample.Truth.Flange.Cast<Transform>().Count(child => child.GetComponent<MeshFilter>() != null)));
        Assert.That(sample.Truth.GetComponentsInChildren<MeshRenderer>(), Has.Length.GreaterThan(3));
        Assert.That(sample.Displayed.Flange.GetComponentsInChildren<MeshRenderer>().Length,
            Is.GreaterThan(sample.Truth.Flange.GetComponentsInChildren<MeshRenderer>().Length));
    }

    [Test]
    public void TruthRig_DisplaySlowerThanCalibrated_ShowsTheResultingError()
    {
        using var calibrated = new PlayedSample().Start().Run(6).Run(10);
        using var slower = new PlayedSample();
        slower.Truth.GetComponent<TruthRig>().With("_displayMs", 90f);
        slower.Start().Run(6).Run(10);

        Assert.That(Rms(slower.Errors), Is.GreaterThan(2 * Rms(calibrated.Errors)));
    }

    [Test]
    public void Play_PausedAndResumed_IsCurrentAgain()
    {
        using var sample = new PlayedSample().Start().Run(6);

        sample.Player.Pause(true);
        sample.Run(2);
        Assert.That(sample.States, Is.Empty);
        sample.Player.Pause(false);
        sample.Run(8);

        Assert.That(sample.States[0], Is.Not.EqualTo(PoseState.Current));
        Assert.That(sample.States[^1], Is.EqualTo(PoseState.Current));
        Assert.That(Complaints(sample), Is.Empty);
    }

    [Test]
    public void ControlSystem_DisabledAndEnabled_Restarts()
    {
        using var sample = new PlayedSample().Start().Run(6);

        sample.Control.enabled = false;
        sample.Run(2);
        Assert.That(sample.States[^1], Is.EqualTo(PoseState.Held));
        sample.Control.enabled = true;
        sample.Run(8);

        Assert.That(sample.States[^1], Is.EqualTo(PoseState.Current));
        Assert.That(Complaints(sample), Is.Empty);
    }

    [TestCase("_session", "session")]
    [TestCase("_robot", "robot")]
    public void ControlSystem_ReferenceMissing_IsLoggedWithoutException(string field, string named)
    {
        using var sample = new PlayedSample();
        sample.Control.With(field, null);

        sample.Start().Run(0.5);

        Assert.That(Complaints(sample)[0], Does.StartWith("[Nowpose] control system '").And.EndsWith($"' has no {named}; assign one"));
        Assert.That(Complaints(sample).Where(text => text.Contains("Exception")), Is.Empty);
        Assert.That(sample.Control.enabled, Is.False);
    }

    [Test]
    public void Frames_WithoutMessages_MostlyAllocateNothing([Values] bool isScene)
    {
        using var sample = (isScene ? PlayedSample.OfScene() : new PlayedSample().Start()).Run(10);
        var allocated = new List<long>(600);

        for (var frame = 0; frame < 600; frame++)
        {
            var before = GC.GetAllocatedBytesForCurrentThread();
            sample.Step();
            allocated.Add(GC.GetAllocatedBytesForCurrentThread() - before);
        }

        // Messages allocate, as they do when they come from a network: joints and three workpieces in every third frame, and a clock exchange in
        // every twelfth frame.
        Assert.That(allocated.Count(bytes => bytes == 0), Is.GreaterThan(600 / 2));
        Assert.That(allocated.Count(bytes => bytes > 600), Is.LessThan(600 / 10), "B: " + string.Join(" ", allocated.Where(bytes => bytes > 0)));
    }
}
