using Nowpose.Editor.Inspectors;
using Nowpose.Editor.Messages;
using Nowpose.Gateway.Plants;
using Nowpose.Unity.Tests.Manual;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Tests that the inspectors report the references that components lack.</summary>
public sealed class MissingAssignmentTests : EditorFixture
{
    // Components that need the session or the rig above them, if none is assigned.
    static IEnumerable<Type> Dependent => InspectedType.All.Where(type => type.Assembly == typeof(MrilSession).Assembly && new InspectedType(type).Fields.Any(
        shown => (shown.Type == typeof(MrilSession) || shown.Type == typeof(RobotRig)) && shown.Tooltip.EndsWith(" a parent.", StringComparison.Ordinal)));

    [TestCaseSource(nameof(Dependent))]
    public void Inspector_ComponentAlone_ReportsWhatItNeedsOnAParent(Type component)
    {
        var alone = Inspect(Keep(new GameObject("alone")).AddComponent(component));
        alone.OnInspectorGUI();

        Assert.That(
            alone, Is.InstanceOf(typeof(LiveInspector<>).MakeGenericType(component)),
            "add an editor to Editor/Inspectors that is derived from LiveInspector");
        Assert.That(GuiRecorder.Texts, Has.Some.Matches<string>(IsReport), "add a SessionRule or a RigRule to Editor/Inspectors/Shortcomings.cs");

        GuiRecorder.Clear();
        var cell = Keep(new GameObject("cell"));
        cell.AddComponent<MrilSession>();
        var robot = new GameObject("robot");
        robot.transform.SetParent(cell.transform);
        if (component != typeof(RobotRig)) robot.AddComponent<RobotRig>();
        Inspect(robot.AddComponent(component)).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Has.None.Matches<string>(IsReport));
    }

    static bool IsReport(string text) => text == ShortcomingTexts.Rig || text.Contains(OfSessions, StringComparison.Ordinal);

    static string OfSessions => ShortcomingTexts.RigSession[..ShortcomingTexts.RigSession.IndexOf('.', StringComparison.Ordinal)];

    [Test]
    public void Inspector_TimestampDisplayWithoutMaterial_AssignsThePackagesMaterial()
    {
        var session = Keep(new GameObject("cell")).AddComponent<MrilSession>();
        var display = session.gameObject.AddComponent<TimestampDisplay>();
        var light = Keep(new Material((Shader)null));
        Project.PutAs(Nowpose.Editor.PackageAsset.Timestamp.Guid, "Timestamp.mat", light);

        Shortcomings.Of([display]).Single(missing => missing.Message == ShortcomingTexts.Light).Fix();

        Assert.That(Shortcomings.Of([display]), Is.Empty);
    }

    [Test]
    public void Inspector_LoadSweepWithoutGenerator_OffersTheOnlyOne()
    {
        var session = Keep(new GameObject("cell")).AddComponent<MrilSession>();
        var sweep = session.gameObject.AddComponent<LoadSweep>();
        Keep(new GameObject("load")).AddComponent<LoadGenerator>();

        var missing = Shortcomings.Of([sweep]).Single();

        Assert.That((missing.Message, missing.FixLabel), Is.EqualTo((ShortcomingTexts.Load, InspectorTexts.Use("load"))));
        missing.Fix();
        Assert.That(Shortcomings.Of([sweep]), Is.Empty);
    }

    [TestCase("gripper_finger_joint_l", true)]
    [TestCase("no_such_joint", false)]
    public void Inspector_ActuatedPartOnAFinger_ReportsTheGripperOnlyIfTheRobotHasTheJoint(string joint, bool isReported)
    {
        var (rig, gripper) = Gripper(out var finger);
        gripper.With("_fingers", new List<GripperFinger> { new(joint, finger) });
        var part = finger.gameObject.AddComponent<ActuatedPart>();

        var reported = Shortcomings.Of([part]).Select(each => each.Message);

        Assert.That(reported.Contains(ShortcomingTexts.MovedByGripper(gripper.name, joint)), Is.EqualTo(isReported));
        Assert.That(rig.Model, Is.Null, "outside play mode");
    }

    [TestCase("gripper_finger_link_l", "gripper_finger_joint_l")]
    [TestCase("tool_centre_point", null)]
    public void Inspector_ActuatedPartOnALink_ReportsTheJointThatMovesIt(string link, string joint)
    {
        var (rig, _) = Gripper(out _);
        var model = Youbot().Read();
        Keep(rig.BuildToStay(model, Keep(new Material((Shader)null))));
        var part = rig.GetComponentsInChildren<Transform>().Single(each => each.name == link).gameObject.AddComponent<ActuatedPart>();

        var reported = Shortcomings.Of([part]).Select(each => each.Message).ToArray();

        if (joint == null) Assert.That(reported, Has.None.Contains(rig.name));
        else Assert.That(reported, Does.Contain(ShortcomingTexts.MovedByJoint(rig.name, joint)));
    }

    [Test]
    public void Inspector_ActuatedPartOnAnObjectOfTheCell_ReportsIt()
    {
        var box = Keep(new GameObject("box")).AddComponent<TrackedObject>();

        var reported = Shortcomings.Of([box.gameObject.AddComponent<ActuatedPart>()]).Select(each => each.Message);

        Assert.That(reported, Does.Contain(ShortcomingTexts.MovedByObject));
    }

    // Such a signal could not switch the object on again.
    [TestCase("lamp", nameof(GameObject.SetActive), true)]
    [TestCase("post", nameof(GameObject.SetActive), true)]
    [TestCase("glow", nameof(GameObject.SetActive), false)]
    [TestCase("lamp", "set_name", false)]
    public void Inspector_SignalSwitchesAnObject_ReportsItIfTheSignalIsAtOrBelowIt(string switched, string method, bool isReported)
    {
        var signal = Lamp(out var objects);
        var call = Call(signal, "_onState", objects.Single(each => each.name == switched), method);

        Assert.That(Messages(signal).Contains(ShortcomingTexts.SwitchesItself(switched)), Is.EqualTo(isReported));
        call.State = UnityEventCallState.Off;
        Assert.That(Messages(signal), Has.None.EqualTo(ShortcomingTexts.SwitchesItself(switched)));
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Inspector_SignalEnablesAComponent_ReportsItIfItIsItself(bool isItself)
    {
        var signal = Lamp(out _);
        Call(signal, "_onNotCurrent", isItself ? signal : signal.gameObject.AddComponent<CellSignal>(), "set_enabled");

        Assert.That(Messages(signal).Contains(ShortcomingTexts.SwitchesItself(signal.name)), Is.EqualTo(isItself));
    }

    CellSignal Lamp(out GameObject[] objects)
    {
        objects = [Keep(new GameObject("post")), new GameObject("lamp"), new GameObject("glow")];
        for (var i = 1; i < objects.Length; i++) objects[i].transform.SetParent(objects[i - 1].transform);
        return objects[1].AddComponent<CellSignal>();
    }

    static PersistentCall Call(CellSignal signal, string field, UnityEngine.Object target, string method)
    {
        var call = PersistentCall.Of(target, method, PersistentListenerMode.EventDefined, null);
        ((UnityEventBase)signal.Shown(field)).Persistent.Add(call);
        return call;
    }

    static string[] Messages(Component component) => [.. Shortcomings.Of([component]).Select(each => each.Message)];

    (RobotRig Rig, VirtualGripper Gripper) Gripper(out Transform finger)
    {
        var session = Keep(new GameObject("cell")).AddComponent<MrilSession>();
        session.RobotAsset = Youbot();
        var rig = new GameObject("Robot").AddComponent<RobotRig>();
        rig.transform.SetParent(session.transform);
        var gripper = new GameObject("Virtual Gripper").AddComponent<VirtualGripper>();
        gripper.transform.SetParent(rig.transform);
        finger = new GameObject("Finger").transform;
        finger.SetParent(gripper.transform);
        return (rig, gripper);
    }

    RobotDescriptionAsset Youbot() => Keep(RobotDescriptionAsset.Create("youbot", RobotFiles.LoadText("youbot")));

    UnityEditor.Editor Inspect(Component component) => Keep(UnityEditor.Editor.CreateEditor(component));
}
