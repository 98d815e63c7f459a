using Nowpose.Gateway.Plants;
using Nowpose.Motion;
using Nowpose.Simulation.Work;
using Nowpose.Session;
using Nowpose.Signals;
using NUnit.Framework;
using UnityEngine;
using KnobRange = UnityEngine.RangeAttribute;
using static Nowpose.Unity.Tests.Samples.SampleErrors;

namespace Nowpose.Unity.Tests.Samples;

public class VirtualWorkTests
{
    [Test]
    public void Scene_Played_WorkpiecesAreAtTheirTruePosesAndStayInTheGripper()
    {
        using var sample = PlayedSample.OfScene();
        var robot = RobotFiles.Load("youbot");
        var work = new CellWork(robot, new PickAndPlaceMotion(robot));
        var world = sample.Session.GetComponentInChildren<BaseAnchor>().transform;
        world.position = new Vector3(0.3f, 0, 0.1f);
        sample.Run(6);
        var shown = work.Names.Select(name => GameObject.Find(name).GetComponent<TrackedObject>()).ToArray();
        var ghosts = work.Names.Select(name => GameObject.Find("ghost of " + name)).ToArray();
        var (errors, held, inHand) = (new List<double>(), new List<double>(), new List<double>());

        for (var frame = 0; frame < 20 * 60; frame++)
        {
            sample.Step();
            // The robot starts to work in the first frame, at 100 s. The display time of a frame is 40 ms after its start.
            var seconds = sample.Session.Frame.Start.SinceEpoch.TotalSeconds + 0.04 - 100;
            for (var i = 0; i < shown.Length; i++)
            {
                Vector3 Truth(double at) => world.TransformPoint(UnityPoses.ToWorld(work.WorldOf(i, at)).position);
                Assert.That(shown[i].State, Is.EqualTo(PoseState.Current), $"{shown[i].name} in {shown[i].Parent} at {seconds} s");
                if (shown[i].Parent == work.Robots[0].Tool)
                    inHand.Add(Vector3.Distance(
                        shown[i].transform.position, sample.Displayed.Tool.TransformPoint(UnityPoses.ToWorld(work.Robots[0].InTool).position)));
                if (Vector3.Distance(Truth(seconds), Truth(seconds - 0.1)) < 1e-3f) continue;
                errors.Add(Vector3.Distance(shown[i].transform.position, Truth(seconds)));
                held.Add(Vector3.Distance(ghosts[i].transform.position, Truth(seconds)));
            }
        }

        Assert.That(Rms(held), Is.GreaterThan(0.01), "there is a gap to close");
        Assert.That(1 - Rms(errors) / Rms(held), Is.GreaterThan(MinReduction));
        Assert.That(inHand, Has.Count.GreaterThan(100));
        Assert.That(inHand.Max(), Is.LessThan(1e-4), "m");
        Assert.That(Complaints(sample), Is.Empty);
        foreach (var name in new[] { "conveyor", "fixture" })
            Assert.That(GameObject.Find(name).GetComponent<StationaryObject>().State, Is.EqualTo(PoseState.Current));
    }

    [Test]
    public void Scene_Played_LampsAndStopFollowTheirSignals()
    {
        using var sample = PlayedSample.OfScene().Run(6);
        var robot = RobotFiles.Load("youbot");
        var work = new CellWork(robot, new PickAndPlaceMotion(robot));
        var lamps = new[] { work.Robots[0].GripperClosed, work.Robots[0].PartPresent };
        var lit = lamps.Select(name => GameObject.Find(name).transform.Find("Lit").gameObject).ToArray();
        var stop = GameObject.Find("Stop").GetComponent<ActuatedPart>();
        var down = stop.transform.localPosition.y - 0.02f * stop.Share;
        var seen = lamps.Append(CellWork.BeltRunning).ToDictionary(name => name, _ => (On: 0, Off: 0));

        for (var frame = 0; frame < 20 * 60; frame++)
        {
            sample.Step();
            // The robot starts to work in the first frame, at 100 s. The display time of a frame is 40 ms after its start.
            var seconds = sample.Session.Frame.Start.SinceEpoch.TotalSeconds + 0.04 - 100;
            for (var i = 0; i < lamps.Length; i++)
                if (SteadyValue(work, lamps[i], seconds, MaxSignalDelay) is bool isOn)
                {
                    Assert.That(lit[i].activeInHierarchy, Is.EqualTo(isOn), $"{lamps[i]} at {seconds} s");
                    Count(lamps[i], isOn);
                }
            if (SteadyValue(work, CellWork.BeltRunning, seconds, MaxSignalDelay + 0.2) is bool isRunning)
            {
                Assert.That(stop.Share, Is.EqualTo(isRunning ? 1 : 0).Within(1e-6), $"stop at {seconds} s");
                Assert.That(stop.transform.localPosition.y - down, Is.EqualTo(isRunning ? 0.02 : 0).Within(1e-6), $"m at {seconds} s");
                Count(CellWork.BeltRunning, isRunning);
            }
            sample.Session.Parts.Update();
            Assert.That(sample.Session.Parts.FaultCount, Is.Zero, $"{sample.Session.Parts.Summary} at {seconds} s");
        }

        foreach (var (name, frames) in seen)
            Assert.That(Math.Min(frames.On, frames.Off), Is.GreaterThan(60), $"{name}: {frames.On} frames on, {frames.Off} frames off");
        Assert.That(Complaints(sample), Is.Empty);

        void Count(string name, bool isOn) => seen[name] = isOn ? (seen[name].On + 1, seen[name].Off) : (seen[name].On, seen[name].Off + 1);
    }

    [Test]
    public void Scene_Played_FingersFollowTheGripperSignalWithoutDelay()
    {
        using var sample = PlayedSample.OfScene().Run(6);
        var robot = RobotFiles.Load("youbot");
        var work = new CellWork(robot, new PickAndPlaceMotion(robot));
        var fingers = sample.Displayed.GetComponentInChildren<VirtualGripper>().GetComponentsInChildren<ActuatedPart>();
        Assert.That(fingers, Has.Length.EqualTo(2));
        var stroke = new ActuatedStroke(0, 1, 0.322);
        var (isClosed, hasArrived, moving, steady) = ((bool?)null, false, 0, 0);

        for (var frame = 0; frame < 30 * 60; frame++)
        {
            sample.Step();
            // The robot starts to work in the first frame, at 100 s. The display time of a frame is 40 ms after its start.
            var seconds = sample.Session.Frame.Start.SinceEpoch.TotalSeconds + 0.04 - 100;
            var isOn = SteadyValue(work, work.Robots[0].GripperClosed, seconds, 0) == true;
            var since = LastChange(work, seconds);
            if (isOn != isClosed)
            {
                stroke.Change(isOn ? 1 : 0, ControlTime.FromSeconds(since));
                (isClosed, hasArrived) = (isOn, false);
            }
            hasArrived |= seconds - since > MaxSignalDelay || Math.Abs(fingers[0].Share - (isOn ? 0 : 1)) > 1e-6;
            if (!hasArrived) continue;
            // From the arrival of the message on, the finger has moved since the control cycle in which the signal changed.
            var expected = stroke.At(ControlTime.FromSeconds(seconds));
            foreach (var finger in fingers) Assert.That(finger.Share, Is.EqualTo(expected).Within(0.05), $"at {seconds} s");
            if (expected is > 0.01 and < 0.99) moving++;
            else steady++;
        }

        Assert.That(moving, Is.GreaterThan(20));
        Assert.That(steady, Is.GreaterThan(500));
    }

    // Returns the time of the newest change of the gripper's signal, s.
    static double LastChange(CellWork work, double seconds)
    {
        Span<double> values = stackalloc double[work.Signals.Count];
        work.SignalsAt(seconds, values);
        var (value, back) = (values[0], seconds);
        while (values[0] == value && back > 0)
        {
            back -= 0.001;
            work.SignalsAt(back, values);
        }
        return back + 0.001;
    }

    /// <summary>Maximum time from a change of a signal until the scene shows it, s: latency and network, with bursts, plus a frame.</summary>
    const double MaxSignalDelay = 0.3;

    // Returns the value of a signal; null if it changed within the given time before, s.
    static bool? SteadyValue(CellWork work, string signal, double seconds, double before)
    {
        var index = work.Signals.ToList().IndexOf(signal);
        Span<double> values = stackalloc double[work.Signals.Count];
        work.SignalsAt(seconds, values);
        var value = values[index];
        for (var back = 0.0; back <= before; back += 0.01)
        {
            work.SignalsAt(seconds - back, values);
            if (values[index] != value) return null;
        }
        return value >= 0.5;
    }
}
