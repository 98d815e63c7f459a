using Nowpose.Editor;
using Nowpose.Headless.Tests.Unity;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Headless.Tests.Editor;

/// <summary>The inspectors, drawn on the editor's stand-in while the player plays.</summary>
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
        Assert.That(GuiRecorder.Texts, Does.Contain("L_visu: 40.0 ms, as calibrated"));
        Assert.That(GuiRecorder.Texts.Single(t => t.StartsWith("End to end: 12", StringComparison.Ordinal)), Does.EndWith(" ms"));
        Assert.That(GuiRecorder.Texts.Single(t => t.StartsWith("L_app 8", StringComparison.Ordinal)), Does.EndWith("ms   (100 ms at the top)"));
        Assert.That(GuiRecorder.Properties, Does.Contain("_settings"));
        Assert.That(GuiRecorder.Lines, Has.Count.EqualTo(3), "latency, horizon, error");
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
    public void Session_NothingKnownYet_SaysDashesAndPlotsNothing()
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
    public void Session_ThatCannotStart_SaysWhy()
    {
        var session = new GameObject("Cell").AddComponent<MrilSession>();

        Inspect(session).OnInspectorGUI();

        Assert.That(string.Join("\n", GuiRecorder.Texts).Replace('\n', ' '), Does.Contain("! " + session.Problem));
        Assert.That(GuiRecorder.Texts, Does.Contain("Pose: –"));
    }

    [Test]
    public void Session_Disabled_SaysDash()
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
    public void Several_AreEditedTogetherWithoutLiveValues()
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
    public void Others_Playing_ShowWhatTheyKnow()
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

        Assert.That(GuiRecorder.Texts, Does.Contain("Rides on: arm_link_5"));
        Assert.That(GuiRecorder.Texts, Does.Contain("Source: nothing measures"));
    }

    [Test]
    public void Fix_OfAMissingReference_IsDoneByTheClickUndoably()
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
