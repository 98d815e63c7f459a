using System.Reflection;
using Nowpose.Unity.Tests;
using Nowpose.Gateway.Plants;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Simulation.Work;
using Nowpose.Samples;
using Nowpose.Session;
using Nowpose.Signals;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using KnobRange = UnityEngine.RangeAttribute;

namespace Nowpose.Unity.Tests.Samples;

public class VirtualRobotCellTests
{
    /// <summary>
    /// Minimum error reduction. The measured values are 0.89 to 0.91, the same on every machine, because time is virtual and random numbers are
    /// seeded.
    /// </summary>
    const double MinReduction = 0.85;

    static readonly (string Name, KnobRange Range)[] Knobs =
    [
        .. typeof(SimulatedControlSystem).GetFields(BindingFlags.NonPublic | BindingFlags.Instance)
            .Select(field => (field.Name, field.GetCustomAttribute<KnobRange>())).Where(knob => knob.Item2 != null),
    ];

    static double Rms(List<double> values) => Math.Sqrt(values.Average(value => value * value));

    static string[] Complaints(PlayedSample sample) =>
        [.. sample.Player.Logs.Where(log => log.Type is LogType.Error or LogType.Exception).Select(log => log.Message)];

    [TestCase("youbot")]
    [TestCase("ur5")]
    public void Play_DefaultSettings_ErrorIsReduced(string robot)
    {
        using var sample = new PlayedSample(robot).Start().Run(6);

        sample.Run(20);

        Assert.That(sample.States, Is.All.EqualTo(PoseState.Current));
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

    static IEnumerable<TestCaseData> Ends() => Knobs.SelectMany(knob => new[]
    {
        new TestCaseData(knob.Name, knob.Range.min), new TestCaseData(knob.Name, knob.Range.max),
    });

    [TestCaseSource(nameof(Ends))]
    public void Setting_ChangedToItsLimitAndBackWhilePlaying_DoesNotThrow(string knob, float value)
    {
        using var sample = new PlayedSample().Start().Run(5);
        var field = typeof(SimulatedControlSystem).GetField(knob, BindingFlags.NonPublic | BindingFlags.Instance);
        var usual = field.GetValue(sample.Control);

        sample.Control.With(knob, value);
        sample.Run(8);
        var atTheEnd = (sample.Errors.Count, Errors: sample.Errors.ToList(), HoldErrors: sample.HoldErrors.ToList());
        sample.Control.With(knob, usual);
        sample.Run(12);

        Assert.That(Complaints(sample), Is.Empty);
        Assert.That(sample.States[^1], Is.EqualTo(PoseState.Current));
        if (atTheEnd.Count > 30)
            Assert.That(Rms(atTheEnd.Errors), Is.LessThan(Rms(atTheEnd.HoldErrors) + 0.001), "current poses are at least as accurate as held ones");
    }

    [Test]
    public void Settings_RandomValues_DoNotThrow([NUnit.Framework.Range(1, 8)] int seed)
    {
        var random = new Random(seed);
        using var sample = new PlayedSample().Start().Run(3);
        for (var turn = 0; turn < 10; turn++)
        {
            foreach (var (name, range) in Knobs) sample.Control.With(name, range.min + (range.max - range.min) * (float)random.NextDouble());
            sample.Control.With("_network", (SimulatedNetwork)random.Next(3));
            sample.Run(0.5);
        }

        Assert.That(Complaints(sample), Is.Empty, "seed " + seed);
    }

    [TestCase("_samplingMs", 1000f)]
    [TestCase("_latencyMinMs", 1000f)]
    [TestCase("_loss", 1f)]
    public void Setting_BeyondThePredictableRange_PoseIsNotCurrent(string knob, float value)
    {
        using var sample = new PlayedSample().Start().Run(6);

        sample.Control.With(knob, value);
        sample.Run(2);
        sample.Run(5);

        Assert.That(sample.States, Has.None.EqualTo(PoseState.Current));
    }

    [Test]
    public void ClockAhead_ChangedWhilePlaying_IsDetectedAsAStep()
    {
        using var sample = new PlayedSample().Start().Run(6);

        sample.Control.With("_clockAheadSeconds", -500f);
        sample.Run(8);
        sample.Run(10);

        Assert.That(sample.Session.Statistics.ClockSteps, Is.EqualTo(1));
        Assert.That(1 - Rms(sample.Errors) / Rms(sample.HoldErrors), Is.GreaterThan(MinReduction));
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

        Assert.That(Complaints(sample)[0], Does.StartWith("[Nowpose] control system").And.Contain(named));
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
