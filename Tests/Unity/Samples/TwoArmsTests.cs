using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Session;
using Nowpose.Simulation.Work;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Samples;

/// <summary>Tests the scene of the sample Virtual Robot Cell in which two arms share a conveyor.</summary>
public class TwoArmsTests
{
    const string Scene = "Packages/com.nowpose.mril/Samples~/Virtual Robot Cell/Virtual Robot Cell (Two Arms).unity";

    static readonly RobotModel Robot = RobotFiles.Load("youbot");
    static readonly CellWork Work = new(Robot, new PickAndPlaceMotion(Robot), 2);

    static double Rms(List<double> values) => Math.Sqrt(values.Average(value => value * value));

    static string[] Complaints(PlayedSample sample) =>
        [.. sample.Player.Logs.Where(log => log.Type is LogType.Error or LogType.Exception).Select(log => log.Message)];

    [Test]
    public void Scene_Played_BothArmsAreAtTheirTruePoses()
    {
        using var sample = PlayedSample.OfScene(Scene);
        sample.Session.GetComponentInChildren<BaseAnchor>().transform.SetPositionAndRotation(Vector3.zero, Quaternion.identity);
        sample.Run(6);
        var second = GameObject.Find("Second Robot").transform;
        var (displayed, held) = (second.Find("Robot").GetComponent<RobotRig>(), second.Find("Ghost").GetComponent<RobotRig>());
        var truth = GameObject.Find("Real Robot 2").GetComponent<RobotRig>();
        var (errors, holdErrors, phases) = (new List<double>(), new List<double>(), new List<double>());

        sample.States.Clear();
        sample.Errors.Clear();
        sample.HoldErrors.Clear();
        for (var frame = 0; frame < 20 * 60; frame++)
        {
            sample.Step();
            Assert.That(displayed.StateIn(sample.Session.Frame), Is.EqualTo(PoseState.Current), $"second arm in frame {frame}");
            errors.Add(Vector3.Distance(displayed.Tool.position, truth.Tool.position));
            holdErrors.Add(Vector3.Distance(held.Tool.position, truth.Tool.position));
            phases.Add(Vector3.Distance(InBase(sample.Truth), InBase(truth)));
        }

        Assert.That(sample.States, Is.All.EqualTo(PoseState.Current));
        foreach (var (compensated, uncompensated) in new[] { (sample.Errors, sample.HoldErrors), (errors, holdErrors) })
        {
            Assert.That(Rms(uncompensated), Is.GreaterThan(0.02), "there is a gap to close");
            Assert.That(1 - Rms(compensated) / Rms(uncompensated), Is.GreaterThan(0.85));
        }
        Assert.That(Vector3.Distance(sample.Truth.transform.position, truth.transform.position), Is.GreaterThan(0.5), "the arms stand apart");
        Assert.That(phases.Max(), Is.GreaterThan(0.1), "m; each arm has its own program");
        Assert.That(Complaints(sample), Is.Empty);

        static Vector3 InBase(RobotRig rig) => rig.transform.InverseTransformPoint(rig.Tool.position);
    }

    [Test]
    public void Scene_Played_EachArmCarriesWorkpiecesOfTheSharedConveyor()
    {
        using var sample = PlayedSample.OfScene(Scene).Run(6);
        var rigs = new[] { sample.Displayed, GameObject.Find("Second Robot").transform.Find("Robot").GetComponent<RobotRig>() };
        var shown = Work.Names.Select(name => GameObject.Find(name).GetComponent<TrackedObject>()).ToArray();
        var inHand = new[] { new List<double>(), new List<double>() };
        var carriedBy = shown.ToDictionary(part => part, _ => new HashSet<int>());

        for (var frame = 0; frame < 3600; frame++)
        {
            sample.Step();
            foreach (var part in shown)
                for (var i = 0; i < rigs.Length; i++)
                    if (part.Parent == Work.Robots[i].Tool)
                    {
                        carriedBy[part].Add(i);
                        inHand[i].Add(Vector3.Distance(
                            part.transform.position, rigs[i].Tool.TransformPoint(UnityPoses.ToWorld(Work.Robots[i].InTool).position)));
                    }
            sample.Session.Parts.Update();
            Assert.That(sample.Session.Parts.FaultCount, Is.Zero, $"{sample.Session.Parts.Summary} in frame {frame}");
        }

        foreach (var distances in inHand)
        {
            Assert.That(distances, Has.Count.GreaterThan(100));
            Assert.That(distances.Max(), Is.LessThan(1e-4), "m");
        }
        Assert.That(carriedBy.Values.Count(arms => arms.Count == 2), Is.GreaterThan(0), "the conveyor brings a workpiece from one arm to the other");
        Assert.That(Complaints(sample), Is.Empty);
    }

    [Test]
    public void Scene_Played_PlannedPathsLeadToWhereTheToolsWillBe()
    {
        using var sample = PlayedSample.OfScene(Scene).Run(8);
        var rigs = new[] { sample.Displayed, GameObject.Find("Second Robot").transform.Find("Robot").GetComponent<RobotRig>() };
        var ahead = new List<(int Frame, int Rig, Vector3 End)>();
        var distances = new List<float>();
        var drawn = 0;

        for (var frame = 0; frame < 600; frame++)
        {
            sample.Step();
            for (var i = 0; i < rigs.Length; i++)
            {
                var path = rigs[i].GetComponentInChildren<PlannedPath>();
                if (path.DrawnSeconds < 0.5) continue;
                drawn++;
                // The line has 30 points per second, and the scene 60 frames per second.
                ahead.Add((frame + 30, i, path.GetComponent<LineRenderer>().GetPosition(15)));
            }
            foreach (var (_, rig, end) in ahead.Where(each => each.Frame == frame)) distances.Add(Vector3.Distance(end, rigs[rig].Tool.position));
        }

        Assert.That(drawn, Is.GreaterThan(2 * 600 * 0.9));
        Assert.That(distances.Max(), Is.LessThan(0.02), "m; the lag behind the set-points is estimated");
        Assert.That(Math.Sqrt(distances.Average(distance => distance * distance)), Is.LessThan(0.005), "m");
    }

    [Test]
    public void ControlSystem_SecondRobotWithoutNamespaceInTheSettings_IsLogged()
    {
        using var sample = new PlayedSample();
        sample.Control.With("_hasSecondRobot", true);

        sample.Start().Run(0.5);

        Assert.That(Complaints(sample), Has.One.Contains("Robot Namespace 'arm1'"));
    }
}
