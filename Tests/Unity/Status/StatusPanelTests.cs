using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Status;

/// <summary>Tests the values that the panel shows about a running session.</summary>
public class StatusPanelTests
{
    PlayedPanel _played;

    [SetUp]
    public void Begin() => _played = new PlayedPanel();

    [TearDown]
    public void End() => _played.Dispose();

    [Test]
    public void LateUpdate_SessionRunning_ShowsItsValues()
    {
        _played.Play(20);

        Assert.That(_played.Row("Pose"), Is.EqualTo(("current", "")));
        Assert.That(_played.Row("Clock").Value, Is.EqualTo("synchronised"));
        Assert.That(_played.Row("Clock").Note, Does.Match(@"^± \d\.\d+ ms$"));
        Assert.That(_played.Row("L_app"), Is.EqualTo(("80.0 ms", StatusMessages.PercentilePrefix + "80 ms")));
        Assert.That(_played.Row("L_visu").Value, Is.EqualTo("40.0 ms"));
        Assert.That(_played.Row("Horizon").Value, Does.Match(@"^1([2-6]\d|70) ms$"));
        Assert.That(_played.Row("Render time"), Is.EqualTo(("9.5 ms", RenderTimeNames.NameOf(RenderTimeSourceKind.DisplayGpuTime))));
        Assert.That(_played.Row("Range"), Is.EqualTo(("inside", "")));
        Assert.That(_played.Row("Error reduction").Value, Does.Match(@"^9\d %$"));
        Assert.That(_played.Row("Gateway"), Is.EqualTo(
            (StatusMessages.Of(LinkState.Idle, LinkState.Idle), StatusMessages.Of(TransportSecurity.Plain, isLocal: true))));
        Assert.That(_played.Row("Robot"), Is.EqualTo(("–", "ur5")));
    }

    [Test]
    public void LateUpdate_JointDataStops_NamesTheJointsInTheMessageAndInTheConsole()
    {
        _played.Play(10);

        _played.Cell.IsPlantUp = false;
        _played.Run(3);

        Assert.That(_played.Row("Pose").Value, Is.EqualTo("! held"));
        Assert.That(
            _played.Text("Message 0").Replace('\n', ' '), Does.Match(@"^! joints shoulder_pan_joint, .*wrist_3_joint: no data since \d\d:\d\d:\d\d$"));
        Assert.That(
            _played.Cell.Messages, Has.Some.Match(SessionMessages.Stale("joints shoulder_pan_joint, .* 0 s")));
    }

    [Test]
    public void LateUpdate_GatewayReportsAJoint_NamesItUntilTheReportEnds()
    {
        _played.Play(10);
        void Report(params JointReport[] joints) =>
            _played.Session.Session.Listener.StatusReceived(new JointStatusMessage(joints), _played.Cell.Clock.Now);

        Report(new JointReport("elbow_joint", JointDataState.Fault, ControlTime.FromSeconds(1305), "node deleted"));
        _played.Run(1);
        var (pose, text) = (_played.Row("Pose").Value, _played.Text("Message 0").Replace('\n', ' '));
        Report();
        _played.Run(1);

        Assert.That(pose, Is.EqualTo("! held"));
        Assert.That(text, Does.Match(@"^! joint elbow_joint: no data since \d\d:\d\d:\d\d: node deleted$"));
        Assert.That(_played.Row("Pose").Value, Is.EqualTo("current"));
        Assert.That(_played.Text("Message 0"), Is.Empty);
    }

    [Test]
    public void LateUpdate_ScriptsRecompiled_RebuildsItsCells()
    {
        _played.Play(1);
        var before = _played.Sheet;
        var scale = before.localScale.x;

        _played.Panel.Cells = null;
        _played.Run(1);

        Assert.That(before == null, "the earlier instances are destroyed");
        Assert.That(_played.Row("Pose").Value, Is.Not.Empty);
        Assert.That(_played.Sheet.localScale.x, Is.EqualTo(scale).Within(1e-6));
    }

    [Test]
    public void OnDisable_Playing_IsHiddenUntilEnabledAgain()
    {
        _played.Panel.With("_ground", new Material((Shader)null));
        // Runs until all labels have appeared. The last ones are the error of the coarse clock and the error reduction.
        _played.Play(8);
        var shown = Seen();

        _played.Panel.enabled = false;
        _played.Run(0.5);
        var hidden = Seen();
        _played.Panel.enabled = true;
        _played.Run(0.5);

        Assert.That(hidden, Is.Empty);
        Assert.That(Seen(), Is.EqualTo(shown).And.Contain("Ground").And.Contain("Pose 0"));
    }

    IEnumerable<string> Seen() =>
    [
        .. _played.Sheet.GetComponentsInChildren<MeshRenderer>().Where(r => r.enabled).Select(r => r.name),
        .. _played.Texts.Where(t => t.text != "").Select(t => t.name),
    ];

    [Test]
    public void OnDestroy_ComponentOnly_RemovesItsObjects()
    {
        _played.Panel.With("_ground", new Material((Shader)null));
        var before = _played.Panel.transform.GetComponentsInChildren<Transform>(true).Length;
        _played.Play(1);
        var panel = _played.Panel.transform;
        Assert.That(panel.GetComponentsInChildren<Transform>(true), Has.Length.GreaterThan(before));

        UnityEngine.Object.Destroy(_played.Panel);
        _played.Run(0.1);

        Assert.That(panel.GetComponentsInChildren<Transform>(true), Has.Length.EqualTo(before));
    }

    [Test]
    public void LateUpdate_FirstFrame_ShowsDashesForUnknownValues()
    {
        _played.Cell.IsPlantUp = false;
        _played.Cell.IsSyncUp = false;

        _played.Play(0.01);

        Assert.That(_played.Row("L_app").Value, Is.EqualTo("–"));
        Assert.That(_played.Row("Error reduction").Value, Is.EqualTo("–"));
        Assert.That(_played.Row("Render time").Value, Is.EqualTo("–"));
        Assert.That(_played.Row("Pose").Value, Is.EqualTo("! " + PoseMessages.Of(PoseState.Incomplete)));
    }

    [Test]
    public void LateUpdate_ChangingValuesAfterWarmUp_AllocatesNothing()
    {
        var random = new System.Random(2);
        _played.EachFrame = _ =>
            _played.Session.Session.Rendered(TimeSpan.FromMilliseconds(8 + 6 * random.NextDouble()), RenderTimeSourceKind.DisplayGpuTime);
        _played.Play(20);
        var changes = _played.Texts.Sum(t => t.TextChanges);

        var allocated = _played.Cell.AllocatedIn(() => _played.Run(4000 / 60.0));

        Assert.That(_played.Texts.Sum(t => t.TextChanges) - changes, Is.GreaterThan(300), "the values change");
        Assert.That(allocated, Is.EqualTo(0));
    }

    [Test]
    public void LateUpdate_ManyFrames_UpdatesOnlyAFewTimesPerSecond()
    {
        _played.EachFrame = frame =>
            _played.Session.Session.Rendered(TimeSpan.FromMilliseconds(5 + frame % 97 * 0.1), RenderTimeSourceKind.DisplayGpuTime);
        _played.Play(5);
        var text = _played.Sheet.Find("RenderTime 1").GetComponent<TextMesh>();
        var before = text.TextChanges;

        _played.Run(10);

        Assert.That(text.TextChanges - before, Is.InRange(30, 40));
    }

    [Test]
    public void LateUpdate_InvalidSettings_ShowsTheReason()
    {
        _played.Session.Settings = null;

        _played.Play(1);

        Assert.That(_played.Text("Message 0").Replace('\n', ' '), Does.Contain(ComponentMessages.NoSettings(_played.Session.name)));
        Assert.That(_played.Row("Clock").Value, Is.EqualTo("–"));
    }

    [Test]
    public void LateUpdate_Paused_ClearsTheNumbers()
    {
        _played.Play(5);

        _played.Cell.Player.Pause(true);
        _played.Run(1);

        Assert.That(_played.Row("L_app").Value, Is.EqualTo("–"));
        Assert.That(_played.Row("Pose").Value, Is.EqualTo("–"));
    }

    [Test]
    public void LateUpdate_SessionDestroyed_ClearsTheNumbers()
    {
        _played.Play(5);

        UnityEngine.Object.Destroy(_played.Session);
        _played.Run(1);

        Assert.That(_played.Row("L_app").Value, Is.EqualTo("–"));
        Assert.That(_played.Row("Pose").Value, Is.EqualTo("–"));
    }

    [Test]
    public void OnDisable_ShowingNumbers_ClearsTheNumbers()
    {
        _played.Play(5);

        _played.Panel.enabled = false;
        var disabled = _played.Texts.Select(t => t.text).ToList();
        _played.Panel.enabled = true;
        _played.Run(0.1);

        Assert.That(disabled, Is.Not.Empty.And.All.Empty);
        Assert.That(_played.Row("L_app").Value, Is.EqualTo("80.0 ms"), "the text is shown again immediately");
    }

    [Test]
    public void OnEnable_NoCell_IsLoggedOnce()
    {
        _played.Panel.With("_cell", null);

        _played.Play(1);

        Assert.That(_played.Cell.Player.Logs.Count(l => l.Message.Contains(ComponentMessages.PanelWithoutText(_played.Panel.name))), Is.EqualTo(1));
        Assert.That(_played.Cell.Player.Logs.Where(l => l.Exception != null), Is.Empty);
    }

    [Test]
    public void OnDestroy_AtAnyFrame_LeaksNothing([Values(0, 1, 2, 40)] int frames)
    {
        _played.Play(0);
        for (var i = 0; i < frames; i++) _played.Cell.Frame(_played.Session);
        var others = _played.Panel.GetComponentsInChildren<Transform>(true).Length;

        UnityEngine.Object.Destroy(_played.Panel.gameObject);
        _played.Run(0.2);
        UnityEngine.Object.Destroy(_played.Session.gameObject);
        UnityEngine.Object.Destroy(_played.Camera.gameObject);
        _played.Cell.Player.Step(1000);

        Assert.That(others, Is.GreaterThan(1));
        Assert.That(_played.Cell.Player.SubscriberCount, Is.EqualTo(0));
        Assert.That(UnityEngine.Object.FindObjectsOfType<Transform>(true), Is.Empty);
        Assert.That(_played.Cell.Player.Logs.Where(l => l.Exception != null), Is.Empty);
    }

    [Test]
    public void LateUpdate_ObjectWithoutPose_HasARowOfItsOwn()
    {
        var lid = new GameObject("lid");
        lid.transform.SetParent(_played.Session.transform, false);
        lid.AddComponent<TrackedObject>();

        _played.Play(10);

        Assert.That(_played.Row("Pose").Value, Is.EqualTo("current"));
        Assert.That(_played.Row("Objects").Value, Is.EqualTo(StatusMessages.NotCurrent(1)));
        Assert.That(_played.Text("FirstPart 1"), Is.EqualTo("! object lid"));
        Assert.That(_played.Text("FirstPart 2"), Is.EqualTo(FrameMessages.NoPose));
        Assert.That(_played.Text("SecondPart 1"), Is.Empty);
        Assert.That(_played.Text("FirstPart 0"), Is.Empty, "never received");
        var pose = RigidTransform.Identity.ToTransform(ControlTime.FromSeconds(1310), FrameParents.World, "lid");
        _played.Session.Session.Listener.FramesReceived(new TransformsMessage(pose), false, _played.Cell.Clock.Now);
        _played.Run(2);
        Assert.That(_played.Text("FirstPart 0"), Does.Match(@"^since \d\d:\d\d:\d\d$"));
        UnityEngine.Object.DestroyImmediate(lid);
        _played.Run(1);
        Assert.That(_played.Texts.Select(text => text.text), Has.None.EqualTo("Objects"));
    }

    [Test]
    public void TextObjects_Deleted_AreMadeAgain()
    {
        _played.Play(1);

        UnityEngine.Object.DestroyImmediate(_played.Sheet.gameObject);
        _played.Run(1);

        Assert.That(_played.Row("Pose").Value, Is.EqualTo("current"));
    }
}
