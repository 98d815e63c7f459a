using Nowpose.Session;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Tests.Rendering;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests;

/// <summary>Tests objects that are elsewhere in the hierarchy, and whose session and name a script sets.</summary>
public class FollowedPartTests : PlayedParts
{
    [Test]
    public void Follow_TrackedObjectElsewhere_ShowsTheFrameAndItsState()
    {
        var tracked = Loose<TrackedObject>("prefab(Clone)");
        var part = PlayedAppearance.Part("look", tracked.transform);

        tracked.Follow(_session, "box");
        tracked.GetComponent<PoseAppearance>().Refresh();
        Run(2, t => SendPose("world", "box", t, Along(0.1 * t)));

        Assert.That((tracked.Frame, tracked.State, tracked.Fault), Is.EqualTo(("box", PoseState.Current, (string)null)));
        AssertAt(tracked.transform, _session.transform, Along(0.1 * (_cell.Now + Visu)), 1e-3);
        Assert.That((part.isVisible, Hatched.IsHatched(part)), Is.EqualTo((true, false)));

        Run(2);
        Assert.That((part.isVisible, Hatched.IsHatched(part)), Is.EqualTo((true, true)), "its poses have stopped");
    }

    [Test]
    public void Follow_ComponentAddedToAnInstanceOfAModel_ShowsTheModelOnlyWithAPose()
    {
        var model = new GameObject("model");
        PlayedAppearance.Part("look", model.transform);
        _session.gameObject.SetActive(true);

        var made = UnityEngine.Object.Instantiate(model, _session.transform);
        var part = made.GetComponentInChildren<MeshRenderer>();
        made.AddComponent<TrackedObject>().Follow(_session, "box");
        Run(1);
        Assert.That(part.isVisible, Is.False);

        Run(1, t => SendPose("world", "box", t, Along(1)));
        Assert.That((part.isVisible, Hatched.IsHatched(part)), Is.EqualTo((true, false)));
    }

    [Test]
    public void Follow_StationaryObjectElsewhere_IsPlacedAtTheFrame()
    {
        var placed = Loose<StationaryObject>("prefab(Clone)");

        placed.Follow(_session, "fixture");
        Run(2, t => SendPose("world", "fixture", t, Along(1)));

        Assert.That(placed.Frame, Is.EqualTo("fixture"));
        AssertAt(placed.transform, _session.transform, Along(1));
        Assert.That(placed.GetComponent<PoseAppearance>().Look.Label, Is.Empty);
    }

    [Test]
    public void Follow_SignalPartsElsewhere_FollowTheSignal()
    {
        var signal = Loose<CellSignal>("lamp");
        var part = Loose<ActuatedPart>("stop");

        signal.Follow(_session, "closed");
        part.Follow(_session, "closed");
        Run(2);
        SendSignal("closed", _cell.Now - 1, 1);
        Run(0.5);

        Assert.That((signal.Signal, signal.Value, part.Signal, part.Share), Is.EqualTo(("closed", (double?)1, "closed", 1f)));
    }

    [Test]
    public void Follow_AnotherSignal_ReportsThatSignalOnly()
    {
        var signal = Below<CellSignal>("first", _session.transform);
        Run(2);
        foreach (var (name, value) in new[] { ("first", 1), ("second", 0) }) SendSignal(name, _cell.Now - 1, value);
        var values = new List<double>();
        signal.Changed += values.Add;
        Run(0.5);

        signal.Follow(null, "second");
        SendSignal("second", _cell.Now - Latency, 0);
        Run(0.5);
        SendSignal("first", _cell.Now - Latency, 0.25);
        SendSignal("second", _cell.Now - Latency, 0.75);
        Run(0.5);

        Assert.That(values, Is.EqualTo(new[] { 1, 0, 0.75 }));
        Assert.That(_session.Parts.Count, Is.EqualTo(1));
    }

    [Test]
    public void Follow_AnotherFrame_ShowsThatFrame()
    {
        var tracked = Below<TrackedObject>("first", _session.transform);
        void Send(double t)
        {
            SendPose("world", "first", t, Along(1));
            SendPose("world", "second", t, Along(2));
        }
        Run(2, Send);
        AssertAt(tracked.transform, _session.transform, Along(1));

        tracked.Follow(null, "second");
        Run(0.5, Send);

        AssertAt(tracked.transform, _session.transform, Along(2));
        Assert.That(_session.Parts.Count, Is.EqualTo(1));
    }

    [Test]
    public void Follow_ComponentsDisabled_ApplyWhenTheyAreEnabled()
    {
        var parts = new MonoBehaviour[] { Loose<TrackedObject>("a"), Loose<StationaryObject>("b"), Loose<CellSignal>("c"), Loose<ActuatedPart>("d") };
        foreach (var part in parts) part.enabled = false;

        ((TrackedObject)parts[0]).Follow(_session);
        ((StationaryObject)parts[1]).Follow(_session);
        ((CellSignal)parts[2]).Follow(_session);
        ((ActuatedPart)parts[3]).Follow(_session);
        Assert.That(_session.Parts.Count, Is.Zero);
        foreach (var part in parts) part.enabled = true;

        Assert.That(_session.Parts.Count, Is.EqualTo(4));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Fault_ComponentDisabledOrObjectInactive_StatesIt(bool isObject)
    {
        var (tracked, placed) = (Loose<TrackedObject>("a"), Loose<StationaryObject>("b"));
        var (signal, part) = (Loose<CellSignal>("c"), Loose<ActuatedPart>("d"));
        var rig = Below<RobotRig>("e", _session.transform);
        var (grip, path) = (Below<GripByReach>("f", rig.transform), Below<PlannedPath>("g", rig.transform));

        foreach (var each in new MonoBehaviour[] { tracked, placed, signal, part, rig, grip, path })
        {
            if (isObject) each.gameObject.SetActive(false);
            else each.enabled = false;
        }

        Assert.That(
            new[] { tracked.Fault, placed.Fault, signal.Fault, part.Fault, rig.Fault, grip.Fault, path.Fault },
            Is.EqualTo(new[]
            {
                ObjectMessages.Disabled("tracked object", "a"), ObjectMessages.Disabled("stationary object", "b"),
                ObjectMessages.Disabled("signal", "c"), ObjectMessages.Disabled("actuated part", "d"), ObjectMessages.Disabled("rig", "e"),
                ObjectMessages.Disabled("grip by reach", "f"), ObjectMessages.Disabled("planned path", "g"),
            }));
    }

    [Test]
    public void Follow_GripByReachElsewhere_GripsWithTheRobotOfTheRig()
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var grip = Loose<GripByReach>("prefab(Clone)");

        grip.Follow(rig, "closed");
        Run(1);
        SendSignal("closed", _cell.Now - 1, 0);
        Run(0.5);
        Assert.That((grip.Signal, grip.Fault), Is.EqualTo(("closed", (string)null)));

        grip.Follow(null);
        Assert.That((grip.Fault, _session.Parts.Count), Is.EqualTo((StatusMessages.NoRig, 0)));
    }

    [Test]
    public void Follow_SignalWithAnAppearanceElsewhere_ShowsWhetherTheSignalIsCurrent()
    {
        var signal = Loose<CellSignal>("lamp");
        var appearance = signal.gameObject.AddComponent<PoseAppearance>();
        var part = PlayedAppearance.Part("look", signal.transform);

        signal.Follow(_session);
        appearance.Refresh();
        Run(2);
        Assert.That((part.isVisible, Hatched.IsHatched(part)), Is.EqualTo((true, true)), "no value has arrived");

        SendSignal("lamp", _cell.Now - 1, 1);
        Run(0.5);
        Assert.That((part.isVisible, Hatched.IsHatched(part)), Is.EqualTo((true, false)));
    }

    [Test]
    public void Follow_AppearanceOfASignalElsewhere_ShowsWhetherTheSignalIsCurrent()
    {
        var appearance = Loose<PoseAppearance>("light");
        var signal = Below<CellSignal>("lamp", appearance.transform);
        var part = PlayedAppearance.Part("look", signal.transform);

        appearance.Follow(_session);
        signal.Follow(_session);
        appearance.Refresh();
        Run(2);
        Assert.That((part.isVisible, Hatched.IsHatched(part)), Is.EqualTo((true, true)), "no value has arrived");

        SendSignal("lamp", _cell.Now - 1, 1);
        Run(0.5);
        Assert.That((part.isVisible, Hatched.IsHatched(part)), Is.EqualTo((true, false)));
    }

    [Test]
    public void Signal_ScriptsRecompiled_IsFollowedAgain()
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var grip = Below<GripByReach>("grip", rig.transform);
        var part = Below<ActuatedPart>("jaw", _session.transform).With("_strokeMs", 0f);
        Run(1);

        grip.Recompile();
        part.Recompile();
        Run(0.1);
        SendSignal("jaw", _cell.Now - 1, 1);
        Run(0.5);

        Assert.That((grip.Signal, part.Fault, part.Share), Is.EqualTo(("grip", (string)null, 1f)));
    }
}
