using System.Reflection;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Status;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Status;

public class StatusPanelTests
{
    PlayedCell _cell;
    MrilSession _session;
    Action<int> _eachFrame;
    int _frames;
    StatusPanel _panel;
    Camera _camera;

    [SetUp]
    public void Begin()
    {
        _cell = new PlayedCell();
        _session = _cell.NewSession("ur5", new SessionSettings(
            new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40),
            range: new ConstantLatencyRange(15, RenderTimeSourceKind.DisplayGpuTime)));
        _eachFrame = null;
        _frames = 0;
        _camera = new GameObject("Camera") { tag = "MainCamera" }.AddComponent<Camera>();
        var panel = new GameObject("Status Panel");
        panel.transform.SetParent(_session.gameObject.transform);
        panel.transform.position = new Vector3(0, 0, 2);
        var cell = new GameObject("Cell").AddComponent<TextMesh>();
        cell.fontSize = 64;
        cell.transform.SetParent(panel.transform, false);
        _panel = panel.AddComponent<StatusPanel>().With("_cell", cell);
    }

    [TearDown]
    public void End() => _cell.Dispose();

    void Play(double seconds)
    {
        _session.gameObject.SetActive(true);
        Run(seconds);
    }

    void Run(double seconds) => _cell.Run(seconds, _session, () => _eachFrame?.Invoke(_frames++));

    Transform Sheet => _panel.transform.Find("Cells");

    TextMesh[] Texts => Sheet.GetComponentsInChildren<TextMesh>();

    /// <summary>Returns value and note beside a label.</summary>
    (string Value, string Note) Row(string label)
    {
        var row = Texts.Single(t => t.text == label).name.Split(' ')[0];
        return (Text(row + " 1"), Text(row + " 2"));
    }

    string Text(string cell) => Sheet.Find(cell).GetComponent<TextMesh>().text;

    [Test]
    public void LateUpdate_WholeSession_ShowsItsValues()
    {
        _eachFrame = _ => _session.Session?.Rendered(TimeSpan.FromMilliseconds(9.5), RenderTimeSourceKind.DisplayGpuTime);

        Play(20);

        Assert.That(Row("Pose"), Is.EqualTo(("current", "")));
        Assert.That(Row("Clock").Value, Is.EqualTo("synchronised"));
        Assert.That(Row("Clock").Note, Does.Match(@"^± \d\.\d+ ms$"));
        Assert.That(Row("L_app"), Is.EqualTo(("80.0 ms", "95 % below 80 ms")));
        Assert.That(Row("L_visu").Value, Is.EqualTo("40.0 ms"));
        Assert.That(Row("Horizon").Value, Does.Match(@"^1[2-6]\d ms$"));
        Assert.That(Row("Render time"), Is.EqualTo(("9.5 ms", "GPU time by headset")));
        Assert.That(Row("Range"), Is.EqualTo(("inside", "")));
        Assert.That(Row("Error reduction").Value, Does.Match(@"^9\d %$"));
        Assert.That(Row("Gateway"), Is.EqualTo(("not connected", "within this machine")));
        Assert.That(Row("Robot"), Is.EqualTo(("–", "ur5")));
    }

    [Test]
    public void LateUpdate_JointDataEnd_NamesTheJointsOnTopAndInTheConsole()
    {
        Play(10);

        _cell.IsPlantUp = false;
        Run(3);

        Assert.That(Row("Pose").Value, Is.EqualTo("! held"));
        Assert.That(Text("Message 0").Replace('\n', ' '), Does.Match(@"^! joints shoulder_pan_joint, .*wrist_3_joint: no data since \d\d:\d\d:\d\d$"));
        Assert.That(_cell.Messages, Has.Some.Match(@"joint positions are stale; the pose is held: joints shoulder_pan_joint, .*: no data since 0 s"));
    }

    [Test]
    public void LateUpdate_GatewayReportsAJoint_NamesItUntilTheReportEnds()
    {
        Play(10);
        void Report(params JointReport[] joints) => _session.Session.Listener.StatusReceived(new JointStatusMessage(joints), _cell.Clock.Now);

        Report(new JointReport("elbow_joint", JointDataState.Fault, ControlTime.FromSeconds(1305), "node deleted"));
        Run(1);
        var (pose, text) = (Row("Pose").Value, Text("Message 0").Replace('\n', ' '));
        Report();
        Run(1);

        Assert.That(pose, Is.EqualTo("! held"));
        Assert.That(text, Does.Match(@"^! joint elbow_joint: no data since \d\d:\d\d:\d\d: node deleted$"));
        Assert.That(Row("Pose").Value, Is.EqualTo("current"));
        Assert.That(Text("Message 0"), Is.Empty);
    }

    [Test]
    public void LateUpdate_ScriptsRecompiled_RebuildsItsCells()
    {
        Play(1);
        var before = Sheet;
        var scale = before.localScale.x;

        typeof(StatusPanel).GetField("_cells", BindingFlags.Instance | BindingFlags.NonPublic).SetValue(_panel, null);
        Run(1);

        Assert.That(before == null, "the old ones are still there");
        Assert.That(Row("Pose").Value, Is.Not.Empty);
        Assert.That(Sheet.localScale.x, Is.EqualTo(scale).Within(1e-6));
    }

    [Test]
    public void Start_Background_CoversTheAreaBehindAllText()
    {
        var material = new Material((Shader)null);
        _panel.With("_ground", material);

        Play(0.1);

        var ground = Sheet.Find("Ground").GetComponent<MeshRenderer>();
        var area = ground.bounds;
        Assert.That(ground.sharedMaterial, Is.SameAs(material));
        foreach (var text in Texts)
        {
            Assert.That(text.transform.position.z, Is.LessThan(area.min.z), text.name);
            Assert.That(text.transform.position.x, Is.InRange(area.min.x, area.max.x), text.name);
            Assert.That(text.transform.position.y, Is.InRange(area.min.y, area.max.y), text.name);
        }
    }

    [Test]
    public void Start_NoGround_CreatesNone()
    {
        Play(0.1);

        Assert.That(Sheet.Find("Ground"), Is.Null);
    }

    [Test]
    public void OnDisable_Playing_IsHiddenUntilEnabledAgain()
    {
        _panel.With("_ground", new Material((Shader)null));
        // Runs beyond the last of the first texts that appear: the coarse clock's error, and the reduction.
        Play(8);
        var shown = Seen();

        _panel.enabled = false;
        Run(0.5);
        var hidden = Seen();
        _panel.enabled = true;
        Run(0.5);

        Assert.That(hidden, Is.Empty);
        Assert.That(Seen(), Is.EqualTo(shown).And.Contain("Ground").And.Contain("Pose 0"));
    }

    IEnumerable<string> Seen() =>
        [.. Sheet.GetComponentsInChildren<MeshRenderer>().Where(r => r.enabled).Select(r => r.name), .. Texts.Where(t => t.text != "").Select(t => t.name)];

    [Test]
    public void OnDestroy_ComponentOnly_RemovesItsObjects()
    {
        _panel.With("_ground", new Material((Shader)null));
        var before = _panel.transform.GetComponentsInChildren<Transform>(true).Length;
        Play(1);
        var panel = _panel.transform;
        Assert.That(panel.GetComponentsInChildren<Transform>(true), Has.Length.GreaterThan(before));

        UnityEngine.Object.Destroy(_panel);
        Run(0.1);

        Assert.That(panel.GetComponentsInChildren<Transform>(true), Has.Length.EqualTo(before));
    }

    [Test]
    public void LateUpdate_FirstFrame_ShowsDashesForUnknownValues()
    {
        _cell.IsPlantUp = false;
        _cell.IsSyncUp = false;

        Play(0.01);

        Assert.That(Row("L_app").Value, Is.EqualTo("–"));
        Assert.That(Row("Error reduction").Value, Is.EqualTo("–"));
        Assert.That(Row("Render time").Value, Is.EqualTo("–"));
        Assert.That(Row("Pose").Value, Is.EqualTo("! no positions yet"));
    }

    [Test]
    public void LateUpdate_WarmWithChangingValues_AllocatesNothing()
    {
        var random = new System.Random(2);
        _eachFrame = _ =>
            _session.Session.Rendered(TimeSpan.FromMilliseconds(8 + 6 * random.NextDouble()), RenderTimeSourceKind.DisplayGpuTime);
        Play(20);
        var changes = Texts.Sum(t => t.TextChanges);

        var allocated = _cell.AllocatedIn(() => Run(4000 / 60.0));

        Assert.That(Texts.Sum(t => t.TextChanges) - changes, Is.GreaterThan(300), "the values do change");
        Assert.That(allocated, Is.EqualTo(0));
    }

    [Test]
    public void LateUpdate_ManyFrames_UpdatesAFewTimesPerSecond()
    {
        _eachFrame = frame =>
            _session.Session.Rendered(TimeSpan.FromMilliseconds(5 + frame % 97 * 0.1), RenderTimeSourceKind.DisplayGpuTime);
        Play(5);
        var text = Sheet.Find("RenderTime 1").GetComponent<TextMesh>();
        var before = text.TextChanges;

        Run(10);

        Assert.That(text.TextChanges - before, Is.InRange(30, 40));
    }

    [TestCase(1)]
    [TestCase(2)]
    [TestCase(5)]
    public void LateUpdate_ViewerAtADistance_LettersAreReadable(float metres)
    {
        _panel.transform.position = new Vector3(0, 0, metres);

        Play(1);

        var text = Texts[0];
        var height = 1409 / 2048.0 * 0.1 * text.fontSize * text.characterSize * text.transform.lossyScale.y;
        Assert.That(2 * Math.Atan(height / 2 / metres) * 180 / Math.PI, Is.InRange(0.5, 0.75));
    }

    [Test]
    public void LateUpdate_RowsAndColumns_DoNotOverlap()
    {
        Play(1);

        var size = Sheet.localScale.x;
        var rows = Texts.Where(t => t.text.Length > 0).Select(t => t.transform.localPosition.y).Distinct().OrderDescending().ToList();
        Assert.That(rows, Has.Count.EqualTo(12), "the message has no text and takes no space");
        Assert.That(rows.Zip(rows.Skip(1), (above, below) => above - below), Is.All.InRange(1.2f, 1.6f), "font sizes");
        Assert.That(Texts.Select(t => t.transform.localPosition.x).Distinct().Count(), Is.EqualTo(3));
        Assert.That(size, Is.EqualTo(Sheet.lossyScale.x).Within(1e-6));
    }

    [Test]
    public void LateUpdate_Message_IsOnTopWithoutMovingTheRows()
    {
        _panel.With("_ground", new Material((Shader)null));
        Play(1);
        var before = (Place("Pose 0"), Place("Base 0"), GroundBounds.min.y, GroundBounds.max.y);

        _session.Settings = null;
        _session.gameObject.SetActive(false);
        _session.gameObject.SetActive(true);
        Run(1);

        Assert.That(Text("Message 0"), Is.Not.Empty);
        Assert.That(Place("Pose 0"), Is.EqualTo(before.Item1).Within(1e-5));
        Assert.That(Place("Base 0"), Is.EqualTo(before.Item2).Within(1e-5));
        Assert.That(GroundBounds.min.y, Is.EqualTo(before.Item3).Within(1e-5), "a bar below stays in the hand");
        Assert.That(GroundBounds.max.y, Is.GreaterThan(before.Item4 + 0.01));
        Assert.That(Place("Message 0"), Is.GreaterThan(Place("Pose 0")));
    }

    float Place(string cell) => Sheet.Find(cell).position.y;

    Bounds GroundBounds => Sheet.Find("Ground").GetComponent<MeshRenderer>().bounds;

    [TestCase(1, 1)]
    [TestCase(4, 1)]
    [TestCase(2, 0.5f)]
    [TestCase(2, 3)]
    public void LateUpdate_Bar_IsAtTheLowerEdgeWithTheLettersScale(float metres, float scale)
    {
        var bar = new GameObject("Bar").transform;
        bar.SetParent(_panel.transform, false);
        _panel.With("_ground", new Material((Shader)null)).With("_bar", bar);
        _panel.transform.position = new Vector3(0, 0, metres);
        _session.transform.localScale = new Vector3(7, 7, 7);
        _panel.transform.localScale = Vector3.one * scale;

        Play(1);

        Assert.That(bar.position.y, Is.EqualTo(GroundBounds.min.y).Within(1e-4));
        Assert.That(bar.lossyScale.x, Is.EqualTo(Sheet.lossyScale.x).Within(1e-6));
        Assert.That(Sheet.lossyScale.x, Is.EqualTo(scale * LetterSize.At(_panel.LegibleMetres.Value)).Within(1e-5), "as the user scaled it");
    }

    [Test]
    public void LateUpdate_UserScalesThePanel_KeepsTheBarAtTheLowerEdge()
    {
        var bar = new GameObject("Bar").transform;
        bar.SetParent(_panel.transform, false);
        _panel.With("_ground", new Material((Shader)null)).With("_bar", bar);
        Play(1);

        _panel.transform.localScale = Vector3.one * 2;

        Assert.That(bar.position.y, Is.EqualTo(GroundBounds.min.y).Within(1e-4), "in the same frame");
        Assert.That(bar.lossyScale.x, Is.EqualTo(Sheet.lossyScale.x).Within(1e-6));
    }

    [Test]
    public void LateUpdate_InvalidSettings_ShowsTheReason()
    {
        _session.Settings = null;

        Play(1);

        Assert.That(Text("Message 0").Replace('\n', ' '), Does.Contain("has no settings; assign a Session Settings asset"));
        Assert.That(Row("Clock").Value, Is.EqualTo("–"));
    }

    [Test]
    public void LateUpdate_Paused_ClearsTheNumbers()
    {
        Play(5);

        _cell.Player.Pause(true);
        Run(1);

        Assert.That(Row("L_app").Value, Is.EqualTo("–"));
        Assert.That(Row("Pose").Value, Is.EqualTo("–"));
    }

    [Test]
    public void LateUpdate_SessionDestroyed_ClearsTheNumbers()
    {
        Play(5);

        UnityEngine.Object.Destroy(_session);
        Run(1);

        Assert.That(Row("L_app").Value, Is.EqualTo("–"));
        Assert.That(Row("Pose").Value, Is.EqualTo("–"));
    }

    [Test]
    public void OnDisable_ShowingNumbers_ClearsThem()
    {
        Play(5);

        _panel.enabled = false;
        var disabled = Texts.Select(t => t.text).ToList();
        _panel.enabled = true;
        Run(0.1);

        Assert.That(disabled, Is.All.Empty);
        Assert.That(Row("L_app").Value, Is.EqualTo("80.0 ms"), "and brings them back at once");
    }

    [Test]
    public void OnEnable_NoCell_IsLoggedOnce()
    {
        _panel.With("_cell", null);

        Play(1);

        Assert.That(_cell.Player.Logs.Count(l => l.Message.Contains("has no text to copy")), Is.EqualTo(1));
        Assert.That(_cell.Player.Logs.Where(l => l.Exception != null), Is.Empty);
    }

    [Test]
    public void OnDestroy_AtAnyFrame_LeaksNothing([Values(0, 1, 2, 40)] int frames)
    {
        Play(0);
        for (var i = 0; i < frames; i++) _cell.Frame(_session);
        var others = _panel.GetComponentsInChildren<Transform>(true).Length;

        UnityEngine.Object.Destroy(_panel.gameObject);
        Run(0.2);
        UnityEngine.Object.Destroy(_session.gameObject);
        UnityEngine.Object.Destroy(_camera.gameObject);
        _cell.Player.Step(1000);

        Assert.That(others, Is.GreaterThan(1));
        Assert.That(_cell.Player.SubscriberCount, Is.EqualTo(0));
        Assert.That(UnityEngine.Object.FindObjectsOfType<Transform>(true), Is.Empty);
        Assert.That(_cell.Player.Logs.Where(l => l.Exception != null), Is.Empty);
    }
}
