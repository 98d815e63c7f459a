using Nowpose.Editor.Inspectors;
using Nowpose.Editor.Messages;
using Nowpose.Editor.Setup;
using Nowpose.Messages;
using Nowpose.Pairing;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Tests;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Tests the inspectors of a session and of the components around it in play mode.</summary>
public sealed class SessionInspectorTests : EditorFixture
{
    PlayedInspectors _played;

    [SetUp]
    public void SetUp() => _played = new PlayedInspectors();

    [TearDown]
    public void TearDown() => _played.Dispose();

    [Test]
    public void Session_Playing_ShowsItsValuesAndPlots()
    {
        var session = _played.Cell.Play();
        var editor = _played.Inspect(session);
        _played.Play(session, 8);

        editor.OnInspectorGUI();

        Assert.That(editor, Is.InstanceOf<MrilSessionEditor>());
        Assert.That(editor.RequiresConstantRepaint());
        Assert.That(GuiRecorder.Texts, Does.Contain("Robot: –, youbot"));
        Assert.That(GuiRecorder.Texts, Does.Contain("Pose: " + PoseMessages.Of(PoseState.Current)));
        Assert.That(GuiRecorder.Texts, Does.Contain("L_visu: 40.0 ms, " + StatusMessages.LatencySet));
        Assert.That(GuiRecorder.Texts.Single(t => t.StartsWith(InspectorTexts.EndToEnd + ": 12", StringComparison.Ordinal)), Does.EndWith(" ms"));
        Assert.That(
            GuiRecorder.Texts.Single(t => t.StartsWith("L_app 8", StringComparison.Ordinal)), Does.EndWith("ms   " + InspectorTexts.AtTop("100 ms")));
        Assert.That(GuiRecorder.Properties, Does.Contain("_settings"));
        Assert.That(GuiRecorder.Lines, Has.Count.EqualTo(3), "latency, horizon, error");
    }

    [Test]
    public void Session_PartNotCurrent_ShowsItsRowsOfTheStatusPanel()
    {
        var session = _played.Cell.Play();
        PlayedInspectors.Below<TrackedObject>(session);
        var editor = _played.Inspect(session);
        _played.Play(session, 1);

        editor.OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain("Objects: " + StatusMessages.NotCurrent(1)));
        Assert.That(GuiRecorder.Texts, Has.Exactly(1).Contains("! object"));
        Assert.That(GuiRecorder.Texts, Has.None.EqualTo(": "), "rows without a part take no space");
    }

    [Test]
    public void LatencyNudge_Playing_ShowsSpeedShiftAndMarks()
    {
        var session = _played.Cell.NewSession();
        var nudge = session.gameObject.AddComponent<LatencyNudge>();
        session.gameObject.SetActive(true);
        var editor = _played.Inspect(nudge);
        _played.Play(session, 8);
        nudge.Step(2);

        editor.OnInspectorGUI();

        Assert.That(editor, Is.InstanceOf<LatencyNudgeEditor>());
        Assert.That(GuiRecorder.Texts, Does.Contain(InspectorTexts.ShiftedBy + ": 2.0 mm"));
        Assert.That(GuiRecorder.Texts, Does.Contain("Marks: " + InspectorTexts.Marks(0, 0)));
    }

    [Test]
    public void LatencyProfileLoader_Playing_ShowsTheUsedProfile()
    {
        var session = _played.Cell.NewSession();
        var loader = session.gameObject.AddComponent<LatencyProfileLoader>().With("_fileName", "none-" + Guid.NewGuid());
        session.gameObject.SetActive(true);
        var editor = _played.Inspect(loader);
        _played.Play(session, 1);

        editor.OnInspectorGUI();

        Assert.That(editor, Is.InstanceOf<LatencyProfileLoaderEditor>());
        Assert.That(GuiRecorder.Texts, Does.Contain("Profile: " + InspectorTexts.NoProfile));
    }

    [Test]
    public void ComponentsAtTheSession_Playing_ShowTheirValues()
    {
        var session = _played.Cell.NewSession();
        session.gameObject.AddComponent<SessionRecording>().With("_recordOnEnable", false);
        session.gameObject.AddComponent<LoadSweep>();
        session.gameObject.AddComponent<CellActions>().SetNudgeMs(2);
        session.gameObject.AddComponent<TimestampDisplay>();
        session.gameObject.SetActive(true);
        _played.Play(session, 8);

        foreach (var shown in new Component[]
            { session.GetComponent<SessionRecording>(), session.GetComponent<LoadSweep>(), session.GetComponent<CellActions>() })
            _played.Inspect(shown).OnInspectorGUI();
        _played.Inspect(session.GetComponent<TimestampDisplay>()).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain("State: " + InspectorTexts.NotRecording).And.Contain("Progress: –")
            .And.Contain(InspectorTexts.NudgeOfVisu + ": 2.0 ms").And.Contain(InspectorTexts.ConnectionRequested + ": no"));
        // The control clock is 300 s ahead of the headset clock, which starts at 1000 s.
        Assert.That(GuiRecorder.Texts, Has.Exactly(1).StartsWith(InspectorTexts.ShownTime + ": 130"));
    }

    [Test]
    public void CellPairing_CodeOnTheClipboard_AsksAndAcceptsTheAnswer()
    {
        var session = _played.Cell.NewSession();
        var file = Path.Combine(Path.GetTempPath(), "none-" + Guid.NewGuid());
        var pairing = session.gameObject.AddComponent<CellPairing>().With("_fileName", file);
        session.gameObject.SetActive(true);
        var editor = _played.Inspect(pairing);
        _played.Play(session, 1);
        EditorGUIUtility.systemCopyBuffer = " nowpose:cell/1?n=desk&h=localhost\n";

        GuiRecorder.Click = InspectorTexts.ReadClipboard;
        editor.OnInspectorGUI();
        GuiRecorder.Click = "Refuse";
        editor.OnInspectorGUI();

        Assert.That(editor, Is.InstanceOf<CellPairingEditor>());
        Assert.That(GuiRecorder.Texts, Has.Some.Contains(PairingMessages.Question(CellCode.Parse("nowpose:cell/1?n=desk&h=localhost"), null)));
        Assert.That(pairing.Question, Is.Null);
        Assert.That(File.Exists(file), Is.False, "a refused cell is not stored");
    }

    [Test]
    public void Session_Playing_PlotsLinesWithinTheirCharts()
    {
        var session = _played.Cell.Play();
        var editor = _played.Inspect(session);
        _played.Play(session, 15);

        editor.OnInspectorGUI();

        var latency = GuiRecorder.Lines[0];
        Assert.That(latency.Select(p => p.x), Is.Ordered.Ascending.And.All.InRange(0, 300));
        Assert.That(latency[^1].x - latency[0].x, Is.EqualTo(300).Within(1), "ten seconds wide");
        Assert.That(latency.Select(p => p.y), Is.All.EqualTo(54 * (1 - 0.8)).Within(2), "80 of 100 ms, from the bottom");
    }

    [Test]
    public void Session_WithoutData_ShowsDashesAndNoPlots()
    {
        var session = _played.Cell.Play();
        _played.Cell.IsSyncUp = _played.Cell.IsPlantUp = false;
        var editor = _played.Inspect(session);
        _played.Play(session, 1);

        editor.OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain("Horizon: –"));
        Assert.That(GuiRecorder.Texts.Single(t => t.StartsWith("L_app –", StringComparison.Ordinal)), Is.Not.Empty);
        Assert.That(GuiRecorder.Lines, Is.Empty);
    }

    [Test]
    public void Session_StartFails_ShowsTheReason()
    {
        var session = new GameObject("Cell").AddComponent<MrilSession>();

        _played.Inspect(session).OnInspectorGUI();

        Assert.That(string.Join("\n", GuiRecorder.Texts).Replace('\n', ' '), Does.Contain("! " + session.Problem));
        Assert.That(GuiRecorder.Texts, Does.Contain("Pose: –"));
    }

    [Test]
    public void Session_RestartClicked_UsesTheChangedSettings()
    {
        var session = _played.Cell.NewSession();
        session.Settings = null;
        var asset = ScriptableObject.CreateInstance<SessionSettingsAsset>();
        session.With("_settings", asset);
        session.gameObject.SetActive(true);
        _played.Cell.Frame(session);
        asset.With("_visualisationMs", 55.0);
        var editor = _played.Inspect(session);
        Assert.That(session.Settings.Visualisation.Length.TotalMilliseconds, Is.EqualTo(40));

        GuiRecorder.Click = InspectorTexts.RestartSession;
        editor.OnInspectorGUI();

        Assert.That(session.Settings.Visualisation.Length.TotalMilliseconds, Is.EqualTo(55));
        Assert.That(session.Session, Is.Not.Null);
    }

    [Test]
    public void Session_Disabled_ShowsADash()
    {
        var session = _played.Cell.Play();
        var editor = _played.Inspect(session);
        _played.Play(session, 1);
        session.enabled = false;
        _played.Play(session, 1);

        editor.OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain("Pose: –"));
        Assert.That(GuiRecorder.Lines, Is.Empty);
    }

    [Test]
    public void Sample_SessionPlaying_AllocatesNothing()
    {
        var session = _played.Cell.Play();
        _played.Inspect(session);
        _played.Play(session, 12);
        var before = GC.GetAllocatedBytesForCurrentThread();

        for (var i = 0; i < 1000; i++)
        {
            EditorApplication.Now += 0.02;
            EditorApplication.update();
        }

        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
    }

    [Test]
    public void SeveralObjects_Selected_AreEditedTogetherWithoutLiveValues()
    {
        MrilSession one = _played.Cell.Play(), two = _played.Cell.Play();
        var editor = _played.Inspect(one, two);
        _played.Play(one, 1);

        editor.OnInspectorGUI();

        Assert.That(editor, Is.InstanceOf<MrilSessionEditor>());
        Assert.That(editor.serializedObject.isEditingMultipleObjects);
        Assert.That(GuiRecorder.Properties, Does.Contain("_settings"));
        Assert.That(GuiRecorder.Texts, Does.Contain(InspectorTexts.OneObject));
        Assert.That(GuiRecorder.Lines, Is.Empty);
        Assert.That(editor.RequiresConstantRepaint(), Is.False);
    }

    [Test]
    public void FixButton_ReferenceMissing_AssignsItWithUndo()
    {
        var session = _played.Cell.NewSession();
        var rig = new GameObject("Robot").AddComponent<RobotRig>();
        var editor = _played.Inspect(rig);
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Buttons, Is.EqualTo(new[] { InspectorTexts.Use("Cell") }));
        Assert.That(Undo.Steps, Is.Empty, "nothing is changed without the click");

        GuiRecorder.Clear();
        GuiRecorder.Click = InspectorTexts.Use("Cell");
        editor.OnInspectorGUI();

        Assert.That(editor.serializedObject.FindProperty("_session").objectReferenceValue, Is.SameAs(session));
        Assert.That(Undo.Steps, Has.Count.EqualTo(1));
    }
}
