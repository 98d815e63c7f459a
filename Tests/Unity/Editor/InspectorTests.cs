using Nowpose.Editor.Messages;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using static Nowpose.Unity.Tests.Editor.PlayedInspectors;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Tests the inspectors of robot, gripper, appearance and panel in play mode.</summary>
public sealed class InspectorTests : EditorFixture
{
    PlayedInspectors _played;

    [SetUp]
    public void SetUp() => _played = new PlayedInspectors();

    [TearDown]
    public void TearDown() => _played.Dispose();

    [Test]
    public void Rig_Playing_ShowsItsJointsInDegreesAndMillimetres()
    {
        var session = _played.Cell.Play();
        var rig = Below<RobotRig>(session);
        _played.Play(session, 2);
        rig.Apply(new[] { Math.PI / 2, 0, 0, 0, 0, 0.0115, 0 });

        _played.Inspect(rig).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain("arm_joint_1: 90.0°"));
        Assert.That(GuiRecorder.Texts, Does.Contain("gripper_finger_joint_l: 11.5 mm"));
        Assert.That(GuiRecorder.Texts, Does.Contain("State: current"));
    }

    [Test]
    public void Ghost_Playing_PlotsTheGapInMillimetres()
    {
        var session = _played.Cell.Play();
        Below<RobotRig>(session);
        var held = Below<RobotRig>(session).With("_shows", RigPose.Held);
        var ghost = held.gameObject.AddComponent<Ghost>();
        _played.Inspect(ghost);
        _played.Play(session, 5);

        _played.Editors[0].OnInspectorGUI();

        Assert.That(GuiRecorder.Lines, Has.Count.EqualTo(1));
        Assert.That(GuiRecorder.Texts, Has.Exactly(1).StartsWith(
            FormattableString.Invariant($"{InspectorTexts.GhostGap} {1000 * ghost.GapMetres:0.##} mm")));
    }

    [Test]
    public void GripperAndRenderTimeSource_Playing_ShowTheirValues()
    {
        var session = _played.Cell.Play();
        var rig = Below<RobotRig>(session);
        var gripper = new GameObject("Gripper");
        gripper.transform.SetParent(rig.transform);
        var mounted = gripper.AddComponent<VirtualGripper>();
        var source = session.gameObject.AddComponent<RenderTimeSource>();
        _played.Play(session, 1);

        _played.Inspect(mounted).OnInspectorGUI();
        _played.Inspect(source).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain(InspectorTexts.AttachedTo + ": arm_link_5"));
        Assert.That(GuiRecorder.Texts, Does.Contain("Source: " + RenderTimeNames.NameOf(RenderTimeSourceKind.None)));
    }

    [Test]
    public void CellParts_Playing_ShowTheirValuesAndFaults()
    {
        var session = _played.Cell.Play();
        var rig = Below<RobotRig>(session);
        var tracked = Below<TrackedObject>(session);
        var part = Below<ActuatedPart>(session);
        var signal = Below<CellSignal>(session);
        var grip = new GameObject("grip").AddComponent<GripByReach>();
        grip.transform.SetParent(rig.transform);
        grip.enabled = false;
        grip.enabled = true;
        var path = rig.gameObject.AddComponent<PlannedPath>();
        var fixture = Below<StationaryObject>(session);
        _played.Play(session, 1);

        foreach (var shown in new Component[] { tracked, part, signal, grip, path, fixture }) _played.Inspect(shown).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain("Parent: –").And.Contain("State: " + FrameMessages.NoPose));
        Assert.That(GuiRecorder.Texts, Does.Contain(InspectorTexts.StrokeShare + ": 0 %").And.Contain("Value: –"));
        Assert.That(GuiRecorder.Texts.Count(text => text.StartsWith("State: " + SignalMessages.NoConnection, StringComparison.Ordinal)), Is.EqualTo(3), "part, signal and gripper");
        Assert.That(GuiRecorder.Texts, Does.Contain("Holds: unknown")
            .And.Contain(InspectorTexts.DrawnAhead + ": nothing").And.Contain(InspectorTexts.MovedByHand + ": no"));
        Assert.That(GuiRecorder.Texts, Does.Contain("State: " + ObjectMessages.NotPlaced).And.Contain("State: " + path.Fault));
    }

    [Test]
    public void StationaryObject_Playing_ShowsItsPoseAndOrigin()
    {
        var session = _played.Cell.Play();
        var fixture = Below<StationaryObject>(session);
        _played.Play(session, 8);
        var editor = _played.Inspect(fixture);
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Parent: –").And.Contain(InspectorTexts.PoseFrom + ": –"));

        GuiRecorder.Clear();
        fixture.transform.localPosition = new Vector3(-1, 2, 3);
        fixture.transform.localRotation = Quaternion.Euler(0, -90, 0);
        fixture.BeginMove();
        _played.Play(session, 0.1);
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain(InspectorTexts.PoseFrom + ": " + ObjectMessages.PlacedByHand).And.Contain("Parent: world")
            .And.Contain(InspectorTexts.ObjectPosition + ": x 3.000   y 1.000   z 2.000").And.Contain(InspectorTexts.ObjectRotation + ": 90.0°"));

        GuiRecorder.Clear();
        fixture.EndMove();
        session.Session.Listener.FramesReceived(
            new TransformsMessage(RigidTransform.FromXyzRpy(0.5, 0.2, 0.1, 0, 0, 0).ToTransform(default, "world", fixture.Frame)), true,
            HeadsetTime.FromSeconds(1000 + _played.Cell.Now));
        _played.Play(session, 0.1);
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain(InspectorTexts.PoseFrom + ": " + RosTopics.TfStatic)
            .And.Contain(InspectorTexts.ObjectPosition + ": x 0.500   y 0.200   z 0.100"));
    }

    [Test]
    public void Signal_Playing_ShowsSinceWhenItHasItsValue()
    {
        var session = _played.Cell.Play();
        var signal = Below<CellSignal>(session);
        _played.Play(session, 8);
        session.Session.Listener.SignalsReceived(
            new SignalsMessage(ControlTime.FromSeconds(1300 + _played.Cell.Now - 1), new SignalValue(signal.Signal, 0.5)),
            HeadsetTime.FromSeconds(1000 + _played.Cell.Now));
        _played.Play(session, 0.1);

        _played.Inspect(signal).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Has.Some.StartsWith("Value: 0.5, " + StatusMessages.Since("")));
    }

    [TestCase(0.0115, "gripper_finger_joint_l: 11.5 mm")]
    [TestCase(0.004, "gripper_finger_joint_l: 4.0 mm")]
    public void Gripper_Playing_ShowsTheOpeningOfItsFingers(double metres, string row)
    {
        var session = _played.Cell.Play();
        var rig = Below<RobotRig>(session);
        var gripper = Gripper(rig, "gripper_finger_joint_l", "gripper_finger_joint_x", "");
        _played.Play(session, 1);
        rig.Apply(new[] { 0, 0, 0, 0, 0, metres, 0 });

        _played.Inspect(gripper).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain(row));
        Assert.That(GuiRecorder.Texts, Does.Contain("gripper_finger_joint_x: " + InspectorTexts.NoFingerJoint("youbot")));
        Assert.That(GuiRecorder.Texts, Does.Contain($"{InspectorTexts.FingerWithoutJoint}: {InspectorTexts.NoFingerJoint("youbot")}"));
    }

    [Test]
    public void Gripper_RigWithoutRobot_ShowsDashes()
    {
        var rig = new GameObject("Robot").AddComponent<RobotRig>();
        var gripper = Gripper(rig, "gripper_finger_joint_l");
        _played.Cell.Frame(null);

        _played.Inspect(gripper).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain(InspectorTexts.AttachedTo + ": –").And.Contain("gripper_finger_joint_l: –"));
    }

    [Test]
    public void Appearance_Playing_ShowsTheStateAndReason()
    {
        var session = _played.Cell.Play();
        var substitute = new Material((Shader)null) { name = "Hologram" };
        substitute.SetFloat("_Fade", 0);
        substitute.SetFloat("_Hatch", 0);
        var appearance = Below<RobotRig>(session).gameObject.AddComponent<PoseAppearance>().With("_substitute", substitute);
        appearance.Refresh();
        var editor = _played.Inspect(appearance);

        _played.Play(session, 8);
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Shown: unchanged").And.Contain("Drawn: plain").And.None.EqualTo("Parts: 0"));

        GuiRecorder.Clear();
        _played.Cell.IsPlantUp = false;
        _played.Play(session, 2);
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Shown: " + PoseMessages.Of(PoseState.Held))
            .And.Contain("Reason: " + StatusMessages.TooFewSamples).And.Contain("Drawn: " + InspectorTexts.Striped("0.5")));

        GuiRecorder.Clear();
        session.enabled = false;
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Shown: " + StatusMessages.NoSession).And.Contain("Reason: " + PoseMessages.SessionPaused));
    }

    [Test]
    public void Appearance_NoPositionsYet_ShowsThatNothingIsDrawn()
    {
        var session = _played.Cell.Play();
        _played.Cell.IsPlantUp = false;
        var appearance = Below<RobotRig>(session).gameObject.AddComponent<PoseAppearance>();
        _played.Play(session, 1);

        _played.Inspect(appearance).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain("Shown: " + PoseMessages.Of(PoseState.Incomplete)).And.Contain("Drawn: nothing"));
    }

    [Test]
    public void Panel_Playing_ShowsItsTexts()
    {
        var session = _played.Cell.Play();
        var panel = Below<StatusPanel>(session);
        panel.enabled = false;
        var cell = new GameObject("Cell text").AddComponent<TextMesh>();
        cell.transform.SetParent(panel.transform);
        cell.gameObject.SetActive(false);
        panel.With("_cell", cell).enabled = true;
        _played.Play(session, 8);

        _played.Inspect(panel).OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Pose: " + PoseMessages.Of(PoseState.Current))
            .And.Contain("L_visu: 40.0 ms, " + StatusMessages.LatencySet).And.Contain(InspectorTexts.LegibleUpTo + ": –"));

        GuiRecorder.Clear();
        panel.enabled = false;
        _played.Editors[0].OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Shows: " + InspectorTexts.Disabled));
    }

    [Test]
    public void BodyFollow_Playing_ShowsItsTargetAndState()
    {
        var head = new GameObject("Head").transform;
        var follow = new GameObject("Panel").AddComponent<BodyFollow>();
        var editor = _played.Inspect(follow);
        _played.Cell.Frame(null);
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Follows: " + InspectorTexts.NoHead));

        GuiRecorder.Clear();
        follow.With("_head", head);
        _played.Cell.Frame(null);
        head.rotation = Quaternion.Euler(0, 20, 0);
        _played.Cell.Frame(null);
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Follows: " + InspectorTexts.Following("Head", isGliding: false))
            .And.Contain($"{InspectorTexts.BesideView}: 20{InspectorTexts.DegreesLeft}").And.Contain(InspectorTexts.FromHead + ": 1.30 m"));

        GuiRecorder.Clear();
        head.rotation = Quaternion.Euler(0, 80, 0);
        _played.Cell.Frame(null);
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Follows: " + InspectorTexts.Following("Head", isGliding: true)));
    }
}
