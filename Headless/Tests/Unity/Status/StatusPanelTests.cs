using Nowpose.Latency;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Headless.Tests.Unity.Status;

public class StatusPanelTests
{
    PlayedSession _played;
    StatusPanel _panel;
    Camera _camera;

    [SetUp]
    public void Begin()
    {
        _played = new PlayedSession(new ConstantLatencyRange(15, RenderTimeSourceKind.GpuTime));
        _camera = new GameObject("Camera") { tag = "MainCamera" }.AddComponent<Camera>();
        var panel = new GameObject("Status Panel");
        panel.transform.SetParent(_played.Cell.transform);
        panel.transform.position = new Vector3(0, 0, 2);
        var cell = new GameObject("Cell").AddComponent<TextMesh>();
        cell.fontSize = 64;
        cell.transform.SetParent(panel.transform, false);
        _panel = panel.AddComponent<StatusPanel>().With("_cell", cell);
    }

    [TearDown]
    public void End() => _played.Dispose();

    Transform Sheet => _panel.transform.Find("Cells");

    TextMesh[] Texts => Sheet.GetComponentsInChildren<TextMesh>();

    /// <summary>What stands behind a label: value and note.</summary>
    (string Value, string Note) Row(string label)
    {
        var row = Texts.Single(t => t.text == label).name.Split(' ')[0];
        return (Text(row + " 1"), Text(row + " 2"));
    }

    string Text(string cell) => Sheet.Find(cell).GetComponent<TextMesh>().text;

    [Test]
    public void LateUpdate_WholeSession_TellsOfIt()
    {
        _played.EachFrame = _ => _played.Session.Session?.Rendered(TimeSpan.FromMilliseconds(9.5), RenderTimeSourceKind.GpuTime);

        _played.Start().Run(20);

        Assert.That(Row("Pose"), Is.EqualTo(("current", "")));
        Assert.That(Row("Clock").Value, Is.EqualTo("synchronised"));
        Assert.That(Row("Clock").Note, Does.Match(@"^± \d\.\d+ ms$"));
        Assert.That(Row("L_app"), Is.EqualTo(("60.0 ms", "95 % below 60 ms")));
        Assert.That(Row("L_visu").Value, Is.EqualTo("40.0 ms"));
        Assert.That(Row("Horizon").Value, Does.Match(@"^1[0-4]\d ms$"));
        Assert.That(Row("Render time"), Is.EqualTo(("9.5 ms", "GPU time")));
        Assert.That(Row("Range"), Is.EqualTo(("inside", "")));
        Assert.That(Row("Error reduction").Value, Does.Match(@"^9\d %$"));
        Assert.That(Row("Gateway"), Is.EqualTo(("not connected", "within this machine")));
        Assert.That(Row("Robot"), Is.EqualTo(("–", "two")));
    }

    [Test]
    public void LateUpdate_FirstFrame_ShowsDashesForWhatIsNotKnown()
    {
        _played.IsSampling = false;
        _played.IsSynchronising = false;

        _played.Start().Step();

        Assert.That(Row("L_app").Value, Is.EqualTo("–"));
        Assert.That(Row("Error reduction").Value, Is.EqualTo("–"));
        Assert.That(Row("Render time").Value, Is.EqualTo("–"));
        Assert.That(Row("Pose").Value, Is.EqualTo("! no positions yet"));
    }

    [Test]
    public void LateUpdate_WarmWithChangingValues_AllocatesNothing()
    {
        var random = new System.Random(2);
        _played.EachFrame = _ =>
            _played.Session.Session.Rendered(TimeSpan.FromMilliseconds(8 + 6 * random.NextDouble()), RenderTimeSourceKind.GpuTime);
        _played.Start().Run(20);
        var changes = Texts.Sum(t => t.TextChanges);
        var before = _played.Allocated;

        for (var i = 0; i < 4000; i++) _played.Step();

        Assert.That(Texts.Sum(t => t.TextChanges) - changes, Is.GreaterThan(300), "the values do change");
        Assert.That(_played.Allocated - before, Is.EqualTo(0));
    }

    [Test]
    public void LateUpdate_ManyFrames_WritesAFewTimesASecond()
    {
        _played.EachFrame = frame =>
            _played.Session.Session.Rendered(TimeSpan.FromMilliseconds(5 + frame % 97 * 0.1), RenderTimeSourceKind.GpuTime);
        _played.Start().Run(5);
        var text = Sheet.Find("RenderTime 1").GetComponent<TextMesh>();
        var before = text.TextChanges;

        _played.Run(10);

        Assert.That(text.TextChanges - before, Is.InRange(30, 40));
    }

    [TestCase(1)]
    [TestCase(2)]
    [TestCase(5)]
    public void LateUpdate_ViewerAtADistance_CanReadTheLetters(float metres)
    {
        _panel.transform.position = new Vector3(0, 0, metres);

        _played.Start().Run(1);

        var text = Texts[0];
        var height = 0.519 * 0.1 * text.fontSize * text.characterSize * text.transform.lossyScale.y;
        Assert.That(2 * Math.Atan(height / 2 / metres) * 180 / Math.PI, Is.InRange(0.5, 0.75));
    }

    [Test]
    public void LateUpdate_RowsAndColumns_DoNotOverlap()
    {
        _played.Start().Run(1);

        var size = Sheet.localScale.x;
        var rows = Texts.Select(t => t.transform.localPosition.y).Distinct().OrderDescending().ToList();
        Assert.That(rows, Has.Count.EqualTo(11));
        Assert.That(rows.Zip(rows.Skip(1), (above, below) => above - below), Is.All.InRange(1.2f, 1.6f), "font sizes");
        Assert.That(Texts.Select(t => t.transform.localPosition.x).Distinct().Count(), Is.EqualTo(3));
        Assert.That(size, Is.EqualTo(Sheet.lossyScale.x).Within(1e-6));
        Assert.That(Texts.Average(t => t.transform.position.y), Is.EqualTo(0).Within(0.05), "about the panel's place");
    }

    [Test]
    public void LateUpdate_BadSettings_SaysWhy()
    {
        _played.Session.Settings = null;

        _played.Start().Run(1);

        Assert.That(Text("Message 0").Replace('\n', ' '), Does.Contain("has no settings; assign a Session Settings asset"));
        Assert.That(Row("Clock").Value, Is.EqualTo("–"));
    }

    [Test]
    public void LateUpdate_Paused_KeepsNoNumbersOfBefore()
    {
        _played.Start().Run(5);

        _played.Player.Pause(true);
        _played.Run(1);

        Assert.That(Row("L_app").Value, Is.EqualTo("–"));
        Assert.That(Row("Pose").Value, Is.EqualTo("–"));
    }

    [Test]
    public void OnDisable_ShowingNumbers_TakesThemAway()
    {
        _played.Start().Run(5);

        _panel.enabled = false;
        var disabled = Texts.Select(t => t.text).ToList();
        _panel.enabled = true;
        _played.Run(0.1);

        Assert.That(disabled, Is.All.Empty);
        Assert.That(Row("L_app").Value, Is.EqualTo("60.0 ms"), "and brings them back at once");
    }

    [Test]
    public void OnEnable_NoCell_SaysSoOnce()
    {
        _panel.With("_cell", null);

        _played.Start().Run(1);

        Assert.That(_played.Player.Logs.Count(l => l.Message.Contains("no cell to copy")), Is.EqualTo(1));
        Assert.That(_played.Player.Logs.Where(l => l.Exception != null), Is.Empty);
    }

    [Test]
    public void OnDestroy_AtAnyFrame_LeavesNothingBehind([Values(0, 1, 2, 40)] int frames)
    {
        _played.Start();
        for (var i = 0; i < frames; i++) _played.Step();
        var others = _panel.GetComponentsInChildren<Transform>(true).Length;

        UnityEngine.Object.Destroy(_panel.gameObject);
        _played.Run(0.2);
        UnityEngine.Object.Destroy(_played.Cell);
        UnityEngine.Object.Destroy(_camera.gameObject);
        _played.Player.Step(1000);

        Assert.That(others, Is.GreaterThan(1));
        Assert.That(_played.Player.SubscriberCount, Is.EqualTo(0));
        Assert.That(UnityEngine.Object.FindObjectsOfType<Transform>(true), Is.Empty);
        Assert.That(_played.Player.Logs.Where(l => l.Exception != null), Is.Empty);
    }
}
