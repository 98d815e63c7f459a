using Nowpose.Editor;
using Nowpose.Editor.Inspectors;
using Nowpose.Editor.Setup;
using Nowpose.Unity;
using Nowpose.Unity.Tests;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>The inspectors in play mode, drawn on the editor's stand-in.</summary>
public sealed class InspectorTests : EditorFixture
{
    PlayedCell _cell;
    readonly List<UnityEditor.Editor> _editors = new();

    [SetUp]
    public void SetUp() => _cell = new PlayedCell();

    [TearDown]
    public void TearDown()
    {
        foreach (var editor in _editors) UnityEngine.Object.DestroyImmediate(editor);
        _editors.Clear();
        _cell.Dispose();
        Assert.That(EditorApplication.update, Is.Null, "an inspector that is closed leaves nothing behind");
    }

    [Test]
    public void Session_Playing_ShowsItsValuesAndPlots()
    {
        var session = _cell.Play();
        var editor = Inspect(session);
        Play(session, 8);

        editor.OnInspectorGUI();

        Assert.That(editor, Is.InstanceOf<MrilSessionEditor>());
        Assert.That(editor.RequiresConstantRepaint());
        Assert.That(GuiRecorder.Texts, Does.Contain("Robot: –, youbot"));
        Assert.That(GuiRecorder.Texts, Does.Contain("Pose: current"));
        Assert.That(GuiRecorder.Texts, Does.Contain("L_visu: 40.0 ms, as set"));
        Assert.That(GuiRecorder.Texts.Single(t => t.StartsWith("End to end: 12", StringComparison.Ordinal)), Does.EndWith(" ms"));
        Assert.That(GuiRecorder.Texts.Single(t => t.StartsWith("L_app 8", StringComparison.Ordinal)), Does.EndWith("ms   (100 ms at the top)"));
        Assert.That(GuiRecorder.Properties, Does.Contain("_settings"));
        Assert.That(GuiRecorder.Lines, Has.Count.EqualTo(3), "latency, horizon, error");
    }

    [Test]
    public void LatencyNudge_Playing_ShowsSpeedShiftAndMarks()
    {
        var session = _cell.NewSession();
        var nudge = session.gameObject.AddComponent<LatencyNudge>();
        session.gameObject.SetActive(true);
        var editor = Inspect(nudge);
        Play(session, 8);
        nudge.Step(2);

        editor.OnInspectorGUI();

        Assert.That(editor, Is.InstanceOf<LatencyNudgeEditor>());
        Assert.That(GuiRecorder.Texts, Does.Contain("Shifted by: 2.0 mm"));
        Assert.That(GuiRecorder.Texts, Does.Contain("Marks: 0 forward, 0 backward"));
    }

    [Test]
    public void LatencyProfileLoader_Playing_ShowsTheUsedProfile()
    {
        var session = _cell.NewSession();
        var loader = session.gameObject.AddComponent<LatencyProfileLoader>().With("_fileName", "none-" + Guid.NewGuid());
        session.gameObject.SetActive(true);
        var editor = Inspect(loader);
        Play(session, 1);

        editor.OnInspectorGUI();

        Assert.That(editor, Is.InstanceOf<LatencyProfileLoaderEditor>());
        Assert.That(GuiRecorder.Texts, Does.Contain("Profile: none; the settings apply"));
    }

    [Test]
    public void CellPairing_CodeOnTheClipboard_AsksAndAcceptsTheAnswer()
    {
        var session = _cell.NewSession();
        var file = Path.Combine(Path.GetTempPath(), "none-" + Guid.NewGuid());
        var pairing = session.gameObject.AddComponent<CellPairing>().With("_fileName", file);
        session.gameObject.SetActive(true);
        var editor = Inspect(pairing);
        Play(session, 1);
        EditorGUIUtility.systemCopyBuffer = " nowpose:cell/1?n=desk&h=localhost\n";

        GuiRecorder.Click = "Read the code on the clipboard";
        editor.OnInspectorGUI();
        GuiRecorder.Click = "Refuse";
        editor.OnInspectorGUI();

        Assert.That(editor, Is.InstanceOf<CellPairingEditor>());
        Assert.That(GuiRecorder.Texts, Has.Some.Contains("Connect to cell 'desk'?"));
        Assert.That(pairing.Question, Is.Null);
        Assert.That(File.Exists(file), Is.False, "what was refused is not kept");
    }

    [Test]
    public void Session_Playing_PlotsLinesWithinTheirStrips()
    {
        var session = _cell.Play();
        var editor = Inspect(session);
        Play(session, 15);

        editor.OnInspectorGUI();

        var latency = GuiRecorder.Lines[0];
        Assert.That(latency.Select(p => p.x), Is.Ordered.Ascending.And.All.InRange(0, 300));
        Assert.That(latency[^1].x - latency[0].x, Is.EqualTo(300).Within(1), "ten seconds wide");
        Assert.That(latency.Select(p => p.y), Is.All.EqualTo(54 * (1 - 0.8)).Within(2), "80 of 100 ms, from the bottom");
    }

    [Test]
    public void Session_WithoutData_ShowsDashesAndNoPlots()
    {
        var session = _cell.Play();
        _cell.IsSyncUp = _cell.IsPlantUp = false;
        var editor = Inspect(session);
        Play(session, 1);

        editor.OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain("Horizon: –"));
        Assert.That(GuiRecorder.Texts.Single(t => t.StartsWith("L_app –", StringComparison.Ordinal)), Is.Not.Empty);
        Assert.That(GuiRecorder.Lines, Is.Empty);
    }

    [Test]
    public void Session_CannotStart_ShowsTheReason()
    {
        var session = new GameObject("Cell").AddComponent<MrilSession>();

        Inspect(session).OnInspectorGUI();

        Assert.That(string.Join("\n", GuiRecorder.Texts).Replace('\n', ' '), Does.Contain("! " + session.Problem));
        Assert.That(GuiRecorder.Texts, Does.Contain("Pose: –"));
    }

    [Test]
    public void Session_Disabled_ShowsADash()
    {
        var session = _cell.Play();
        var editor = Inspect(session);
        Play(session, 1);
        session.enabled = false;
        Play(session, 1);

        editor.OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain("Pose: –"));
        Assert.That(GuiRecorder.Lines, Is.Empty);
    }

    [Test]
    public void Sampling_OfAPlayingSession_AllocatesNothing()
    {
        var session = _cell.Play();
        Inspect(session);
        Play(session, 12);
        var before = GC.GetAllocatedBytesForCurrentThread();

        for (var i = 0; i < 1000; i++)
        {
            EditorApplication.Now += 0.02;
            EditorApplication.update();
        }

        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
    }

    [Test]
    public void Several_Selected_AreEditedTogetherWithoutLiveValues()
    {
        MrilSession one = _cell.Play(), two = _cell.Play();
        var editor = Inspect(one, two);
        Play(one, 1);

        editor.OnInspectorGUI();

        Assert.That(editor, Is.InstanceOf<MrilSessionEditor>());
        Assert.That(editor.serializedObject.isEditingMultipleObjects);
        Assert.That(GuiRecorder.Properties, Does.Contain("_settings"));
        Assert.That(GuiRecorder.Texts, Does.Contain("Live values are shown for one object at a time."));
        Assert.That(GuiRecorder.Lines, Is.Empty);
        Assert.That(editor.RequiresConstantRepaint(), Is.False);
    }

    [Test]
    public void Rig_Playing_ShowsItsJointsInDegreesAndMillimetres()
    {
        var session = _cell.Play();
        var rig = Below<RobotRig>(session);
        Play(session, 2);
        rig.Apply(new[] { Math.PI / 2, 0, 0, 0, 0, 0.0115, 0 });

        Inspect(rig).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain("arm_joint_1: 90.0°"));
        Assert.That(GuiRecorder.Texts, Does.Contain("gripper_finger_joint_l: 11.5 mm"));
    }

    [Test]
    public void Ghost_Playing_PlotsTheGapInMillimetres()
    {
        var session = _cell.Play();
        Below<RobotRig>(session);
        var held = Below<RobotRig>(session).With("_shows", RigPose.Held);
        var ghost = held.gameObject.AddComponent<Ghost>();
        Inspect(ghost);
        Play(session, 5);

        _editors[0].OnInspectorGUI();

        Assert.That(GuiRecorder.Lines, Has.Count.EqualTo(1));
        Assert.That(
            GuiRecorder.Texts.Single(t => t.StartsWith("Gap", StringComparison.Ordinal)),
            Does.StartWith(FormattableString.Invariant($"Gap to the displayed tool {1000 * ghost.GapMetres:0.##} mm")));
    }

    [Test]
    public void Others_Playing_ShowTheirValues()
    {
        var session = _cell.Play();
        var rig = Below<RobotRig>(session);
        var gripper = new GameObject("Gripper");
        gripper.transform.SetParent(rig.transform);
        var mounted = gripper.AddComponent<VirtualGripper>();
        var source = session.gameObject.AddComponent<RenderTimeSource>();
        Play(session, 1);

        Inspect(mounted).OnInspectorGUI();
        Inspect(source).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain("Attached to: arm_link_5"));
        Assert.That(GuiRecorder.Texts, Does.Contain("Source: nothing measures"));
    }

    [TestCase(0.0115, "gripper_finger_joint_l: 11.5 mm")]
    [TestCase(0.004, "gripper_finger_joint_l: 4.0 mm")]
    public void Gripper_Playing_ShowsTheOpeningOfItsFingers(double metres, string row)
    {
        var session = _cell.Play();
        var rig = Below<RobotRig>(session);
        var gripper = Gripper(rig, "gripper_finger_joint_l", "gripper_finger_joint_x", "");
        Play(session, 1);
        rig.Apply(new[] { 0, 0, 0, 0, 0, metres, 0 });

        Inspect(gripper).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain(row));
        Assert.That(GuiRecorder.Texts, Does.Contain("gripper_finger_joint_x: robot 'youbot' has no such joint; the finger does not move"));
        Assert.That(GuiRecorder.Texts, Does.Contain("A finger without a joint: robot 'youbot' has no such joint; the finger does not move"));
    }

    [Test]
    public void Gripper_OnARigWithoutRobot_ShowsDashes()
    {
        var rig = new GameObject("Robot").AddComponent<RobotRig>();
        var gripper = Gripper(rig, "gripper_finger_joint_l");
        _cell.Frame(null);

        Inspect(gripper).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain("Attached to: –").And.Contain("gripper_finger_joint_l: –"));
    }

    [Test]
    public void Appearance_Playing_ShowsTheStateAndReason()
    {
        var session = _cell.Play();
        var substitute = new Material((Shader)null) { name = "Hologram" };
        substitute.SetFloat("_Fade", 0);
        substitute.SetFloat("_Hatch", 0);
        var appearance = Below<RobotRig>(session).gameObject.AddComponent<PoseAppearance>().With("_substitute", substitute);
        appearance.Refresh();
        var editor = Inspect(appearance);

        Play(session, 8);
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Shown: unchanged").And.Contain("Drawn: plain").And.None.EqualTo("Parts: 0"));

        GuiRecorder.Clear();
        _cell.IsPlantUp = false;
        Play(session, 2);
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Shown: held").And.Contain("Reason: samples too old or few").And.Contain("Drawn: striped, fade 0.5"));

        GuiRecorder.Clear();
        session.enabled = false;
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Shown: no session").And.Contain("Reason: the session is disabled or paused"));
    }

    [Test]
    public void Appearance_BeforeAnyPosition_ShowsThatNothingIsDrawn()
    {
        var session = _cell.Play();
        _cell.IsPlantUp = false;
        var appearance = Below<RobotRig>(session).gameObject.AddComponent<PoseAppearance>();
        Play(session, 1);

        Inspect(appearance).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain("Shown: no positions yet").And.Contain("Drawn: nothing"));
    }

    [Test]
    public void Panel_Playing_ShowsItsTexts()
    {
        var session = _cell.Play();
        var panel = Below<StatusPanel>(session);
        panel.enabled = false;
        var cell = new GameObject("Cell text").AddComponent<TextMesh>();
        cell.transform.SetParent(panel.transform);
        cell.gameObject.SetActive(false);
        panel.With("_cell", cell).enabled = true;
        Play(session, 8);

        Inspect(panel).OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Pose: current").And.Contain("L_visu: 40.0 ms, as set").And.Contain("Legible up to: –"));

        GuiRecorder.Clear();
        panel.enabled = false;
        _editors[0].OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Shows: nothing, it is disabled"));
    }

    [Test]
    public void BodyFollow_Playing_ShowsItsTargetAndState()
    {
        var head = new GameObject("Head").transform;
        var follow = new GameObject("Panel").AddComponent<BodyFollow>();
        var editor = Inspect(follow);
        _cell.Frame(null);
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Follows: nothing: Head is empty, and no camera is tagged MainCamera"));

        GuiRecorder.Clear();
        follow.With("_head", head);
        _cell.Frame(null);
        head.rotation = Quaternion.Euler(0, 20, 0);
        _cell.Frame(null);
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Follows: Head, staying put").And.Contain("Beside the view: 20° to the left"));
        Assert.That(GuiRecorder.Texts, Does.Contain("From the head: 1.30 m"));

        GuiRecorder.Clear();
        head.rotation = Quaternion.Euler(0, 80, 0);
        _cell.Frame(null);
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Texts, Does.Contain("Follows: Head, gliding"));
    }

    [Test]
    public void Fix_OfAMissingReference_IsAppliedByTheClickWithUndo()
    {
        var session = _cell.NewSession();
        var rig = new GameObject("Robot").AddComponent<RobotRig>();
        var editor = Inspect(rig);
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Buttons, Is.EqualTo(new[] { "Use 'Cell'" }));
        Assert.That(Undo.Steps, Is.Empty, "nothing is changed without the click");

        GuiRecorder.Clear();
        GuiRecorder.Click = "Use 'Cell'";
        editor.OnInspectorGUI();

        Assert.That(editor.serializedObject.FindProperty("_session").objectReferenceValue, Is.SameAs(session));
        Assert.That(Undo.Steps, Has.Count.EqualTo(1));
    }

    UnityEditor.Editor Inspect(params Component[] components)
    {
        var editor = UnityEditor.Editor.CreateEditor(components);
        _editors.Add(editor);
        return editor;
    }

    static VirtualGripper Gripper(RobotRig rig, params string[] joints)
    {
        var gripper = new GameObject("Gripper");
        gripper.transform.SetParent(rig.transform);
        var fingers = joints.Select(joint => new GripperFinger(joint, new GameObject("Finger").transform)).ToList();
        foreach (var finger in fingers) finger.Finger.SetParent(gripper.transform);
        return gripper.AddComponent<VirtualGripper>().With("_fingers", fingers);
    }

    static T Below<T>(MrilSession session) where T : Component
    {
        var child = new GameObject(typeof(T).Name);
        child.transform.SetParent(session.transform);
        return child.AddComponent<T>();
    }

    void Play(MrilSession session, double seconds) => _cell.Run(seconds, session, () =>
    {
        EditorApplication.Now = _cell.Now;
        EditorApplication.update?.Invoke();
    });
}
