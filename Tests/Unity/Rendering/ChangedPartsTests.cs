using Nowpose.Gateway.Plants;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Hatched;
using static Nowpose.Unity.Tests.Rendering.PlayedAppearance;

namespace Nowpose.Unity.Tests.Rendering;

/// <summary>Tests parts that a script adds, moves or disables while the session runs. They must not look current by mistake.</summary>
public class ChangedPartsTests : PlayedParts
{
    static readonly Type[] OfSignals = [typeof(CellSignal), typeof(ActuatedPart)];

    [TestCaseSource(nameof(OfSignals))]
    public void Show_SignalAddedBelowAnAppearance_StripesItsParts(Type component)
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var appearance = rig.gameObject.AddComponent<PoseAppearance>();
        var (lamp, other) = (Part("lamp", rig.transform), Part("other", rig.transform));
        appearance.Refresh();
        Run(1);
        Assert.That((IsHatched(lamp), IsHatched(other)), Is.EqualTo((false, false)));

        lamp.gameObject.AddComponent(component);
        Run(0.1);
        Assert.That((IsHatched(lamp), IsHatched(other)), Is.EqualTo((true, false)), "the signal has no value");

        SendSignal("lamp", _cell.Now - 1, 1);
        Run(0.5);
        Assert.That((IsHatched(lamp), appearance.Look.Label), Is.EqualTo((false, "")));
    }

    [Test]
    public void Show_ActuatedPartAddedAboveAnAppearance_StripesTheParts()
    {
        var slide = Child("slide", _session.transform);
        var jaw = Part("jaw", slide.transform);
        jaw.gameObject.AddComponent<PoseAppearance>();
        Run(1);
        Assert.That((IsHatched(jaw), jaw.isVisible), Is.EqualTo((false, true)));

        slide.AddComponent<ActuatedPart>();
        Run(0.1);

        Assert.That(IsHatched(jaw), Is.True);
    }

    // All renderers of the tool change, not only those of the component.
    [TestCaseSource(nameof(OfSignals))]
    public void Show_ToolWithASignalMoved_HasTheLookOfItsNewPlace(Type component)
    {
        var (rack, arm) = (Below<TrackedObject>("rack", _session.transform), Below<TrackedObject>("arm", _session.transform));
        var tool = Child("tool", rack.transform);
        var (body, jaw) = (Part("body", tool.transform), Part("jaw", tool.transform));
        jaw.gameObject.AddComponent(component);
        rack.GetComponent<PoseAppearance>().Refresh();
        Run(1, t => SendPose("world", "arm", t, Along(1)));
        SendSignal("jaw", _cell.Now - 1, 1);
        Run(0.5, t => SendPose("world", "arm", t, Along(1)));
        Assert.That((body.isVisible, jaw.isVisible), Is.EqualTo((false, false)), "the rack has no pose");

        tool.transform.SetParent(arm.transform, false);
        Assert.That((rack.GetComponent<PoseAppearance>().PartCount, arm.GetComponent<PoseAppearance>().PartCount), Is.EqualTo((0, 2)));
        Run(0.5, t => SendPose("world", "arm", t, Along(1)));
        Assert.That((IsHatched(body), IsHatched(jaw), body.isVisible), Is.EqualTo((false, false, true)));

        Run(1);
        Assert.That((IsHatched(body), IsHatched(jaw)), Is.EqualTo((true, true)), "the poses of the arm have stopped");
        tool.transform.SetParent(null, false);
        Assert.That((IsHatched(body), IsHatched(jaw)), Is.EqualTo((false, false)), "their own look");
    }

    [Test]
    public void Show_PartMovedBelowAnAppearanceOfTheSameObject_KeepsItsOriginalLook()
    {
        var outer = Below<TrackedObject>("outer", _session.transform);
        var inner = Below<TrackedObject>("inner", outer.transform);
        var jaw = Part("jaw", outer.transform);
        jaw.gameObject.AddComponent<CellSignal>();
        void Send(double t) => SendPose("world", "inner", t, Along(1));
        Run(1, t => SendPose("world", "outer", t, Along(1)));
        SendSignal("jaw", _cell.Now - 1, 1);
        Run(1, Send);
        Assert.That(IsHatched(jaw), Is.True, "the poses of the outer object have stopped");

        foreach (var parent in new[] { inner, outer, inner }) jaw.transform.SetParent(parent.transform, false);
        Run(0.5, Send);

        Assert.That((IsHatched(jaw), jaw.isVisible), Is.EqualTo((false, true)));
    }

    [Test]
    public void Show_AppearanceMovedBelowAnotherActuatedPart_HasTheStateOfItsSignal()
    {
        var (first, second) = (Below<ActuatedPart>("first", _session.transform), Below<ActuatedPart>("second", _session.transform));
        var jaw = Part("jaw", first.transform);
        jaw.gameObject.AddComponent<PoseAppearance>();
        Run(1);
        SendSignal("first", _cell.Now - 1, 1);
        Run(0.5);
        Assert.That(IsHatched(jaw), Is.False);

        jaw.transform.SetParent(second.transform, false);
        Run(0.1);
        Assert.That(IsHatched(jaw), Is.True, "the second signal has no value");
    }

    [Test]
    public void Show_AppearanceMovedOrAddedBelowAnotherAndDisabled_TheOtherTakesOverItsParts([Values] bool isMoved)
    {
        var rack = Below<TrackedObject>("rack", _session.transform);
        Run(1);
        var box = Child("box", isMoved ? _session.transform : rack.transform).AddComponent<PoseAppearance>();
        var look = Part("look", box.transform);
        box.Refresh();
        Run(0.1);
        if (isMoved) box.transform.SetParent(rack.transform, false);
        Run(0.1);

        box.enabled = false;
        Run(0.1);

        Assert.That(look.isVisible, Is.False, "the rack has no pose");
    }

    [Test]
    public void Show_GripperMovedToAnotherRig_BelongsToTheAppearanceOfThatRig()
    {
        var first = Below<RobotRig>("First", _session.transform).gameObject.AddComponent<PoseAppearance>();
        var second = Second(RobotFiles.LoadText("youbot"));
        second.gameObject.AddComponent<PoseAppearance>();
        var gripper = Below<VirtualGripper>("gripper", first.transform);
        var palm = Part("palm", gripper.transform);
        first.Refresh();
        Run(1);
        Assert.That((palm.isVisible, IsHatched(palm)), Is.EqualTo((true, false)));

        gripper.transform.SetParent(second.transform, false);
        first.enabled = false;
        Run(0.1);

        Assert.That(palm.isVisible, Is.False, "the second robot has no samples");
    }

    // A robot may have hundreds of renderers, and each added signal refreshes the appearances above it.
    [Test]
    public void Refresh_PartsFarBelow_AllocatesNoMoreThanForPartsDirectlyBelow()
    {
        var appearance = Child("look", _session.transform).AddComponent<PoseAppearance>();
        var parts = Child("parts", appearance.transform);
        for (var i = 0; i < 100; i++) Part("part" + i, parts.transform);
        Run(0.1);
        var near = RefreshedBytes(appearance);

        var at = appearance.transform;
        for (var i = 0; i < 8; i++) at = Child("level" + i, at).transform;
        parts.transform.SetParent(at, false);

        Assert.That(RefreshedBytes(appearance), Is.LessThan(near + 1000));
        Assert.That(appearance.PartCount, Is.EqualTo(100));
    }

    static long RefreshedBytes(PoseAppearance appearance)
    {
        appearance.Refresh();
        var before = GC.GetAllocatedBytesForCurrentThread();
        appearance.Refresh();
        return GC.GetAllocatedBytesForCurrentThread() - before;
    }

    [Test]
    public void Show_GripperMountedOnAnotherRig_HasTheStateOfThatRobot()
    {
        var second = Second(RobotFiles.LoadText("youbot"));
        var place = Child("place", _session.transform).AddComponent<PoseAppearance>();
        var gripper = Below<VirtualGripper>("gripper", place.transform);
        var palm = Part("palm", gripper.transform);
        place.Refresh();
        Run(1);

        gripper.Mount(second);
        Run(0.1);

        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That((second.IsFollowing, palm.isVisible), Is.EqualTo((true, false)), "the second robot has no samples");
    }

    [Test]
    public void ActuatedPart_DisabledDuringItsUse_StaysWhereItIsAndIsNotCurrent()
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var appearance = rig.gameObject.AddComponent<PoseAppearance>();
        var jaw = Below<ActuatedPart>("jaw", rig.transform).With("_wayMetres", new Vector3(0, 0, 0.02f)).With("_strokeMs", 0f);
        var moved = Part("moved", jaw.transform);
        appearance.Refresh();
        Run(1);
        SendSignal("jaw", _cell.Now - 1, 1);
        Run(0.5);
        var end = jaw.transform.localPosition;
        Assert.That((end.z, IsHatched(moved)), Is.EqualTo((0.02f, false)));

        jaw.enabled = false;
        SendSignal("jaw", _cell.Now - Latency, 0);
        Run(0.5);
        Assert.That((jaw.transform.localPosition, jaw.Fault), Is.EqualTo((end, ObjectMessages.Disabled("actuated part", "jaw"))));
        Assert.That((IsHatched(moved), appearance.Look.Label), Is.EqualTo((true, ObjectMessages.SignalNotCurrent)));

        jaw.gameObject.SetActive(false);
        Run(0.1);
        Assert.That((jaw.transform.localPosition, appearance.Look.Label), Is.EqualTo((end, "")), "nothing of it is drawn");

        jaw.gameObject.SetActive(true);
        jaw.enabled = true;
        Run(0.1);
        Assert.That(Vector3.Distance(jaw.transform.localPosition, Vector3.zero), Is.LessThan(1e-6), "the pose for 0 is that of the first time");
        Assert.That((IsHatched(moved), appearance.Look.Label), Is.EqualTo((false, "")));
    }

    // A refresh would find the part that the test adds.
    [TestCaseSource(nameof(OfSignals))]
    public void Component_SwitchedOffAndOnAtTheSamePlace_DoesNotRefreshTheAppearance(Type component)
    {
        var appearance = Child("cabinet", _session.transform).AddComponent<PoseAppearance>();
        var lamp = Part("lamp", appearance.transform);
        lamp.gameObject.AddComponent(component);
        Run(0.1);
        Part("later", appearance.transform);

        lamp.gameObject.SetActive(false);
        lamp.gameObject.SetActive(true);

        Assert.That(appearance.PartCount, Is.EqualTo(1));
    }

    [TestCaseSource(nameof(OfSignals))]
    public void Component_ReturnedWhileInactive_IsAPartAgain(Type component)
    {
        var appearance = Child("cabinet", _session.transform).AddComponent<PoseAppearance>();
        var lamp = Part("lamp", appearance.transform);
        lamp.gameObject.AddComponent(component);
        Run(0.1);
        lamp.gameObject.SetActive(false);
        lamp.transform.SetParent(null, false);
        appearance.Refresh();
        Assert.That(appearance.PartCount, Is.Zero);
        lamp.transform.SetParent(appearance.transform, false);

        lamp.gameObject.SetActive(true);
        Run(0.1);

        Assert.That((appearance.PartCount, IsHatched(lamp)), Is.EqualTo((1, true)), "the signal has no value");
    }

    [Test]
    public void ActuatedPart_Destroyed_StaysWhereItIsWithoutAFault()
    {
        var jaw = Below<ActuatedPart>("jaw", _session.transform).With("_wayMetres", new Vector3(0, 0, 0.02f)).With("_strokeMs", 0f);
        var moved = Part("moved", jaw.transform);
        var appearance = jaw.gameObject.AddComponent<PoseAppearance>();
        Run(1);
        SendSignal("jaw", _cell.Now - 1, 1);
        Run(0.5);

        UnityEngine.Object.Destroy(jaw);
        Run(0.1);

        Assert.That((moved.transform.position.z, IsHatched(moved), appearance.Look.Label), Is.EqualTo((0.02f, false, "")));
    }
}
