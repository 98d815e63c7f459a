using Nowpose.Unity;
using Nowpose.Unity.Status;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Status;

/// <summary>Tests the positions and sizes of the panel's labels, background and bar.</summary>
public class StatusPanelLayoutTests
{
    PlayedPanel _played;

    [SetUp]
    public void Begin() => _played = new PlayedPanel();

    [TearDown]
    public void End() => _played.Dispose();

    [Test]
    public void Start_Background_CoversTheAreaBehindAllText()
    {
        var material = new Material((Shader)null);
        _played.Panel.With("_ground", material);

        _played.Play(0.1);

        var ground = _played.Sheet.Find("Ground").GetComponent<MeshRenderer>();
        var area = ground.bounds;
        Assert.That(ground.sharedMaterial, Is.SameAs(material));
        Assert.That(_played.Texts, Is.Not.Empty);
        foreach (var text in _played.Texts)
        {
            Assert.That(text.transform.position.z, Is.LessThan(area.min.z), text.name);
            Assert.That(text.transform.position.x, Is.InRange(area.min.x, area.max.x), text.name);
            Assert.That(text.transform.position.y, Is.InRange(area.min.y, area.max.y), text.name);
        }
    }

    [Test]
    public void Start_NoBackgroundMaterial_CreatesNoBackground()
    {
        _played.Play(0.1);

        Assert.That(_played.Sheet.Find("Ground"), Is.Null);
    }

    /// <summary>After a month, a time in s as float has a resolution of 0.25 s.</summary>
    [TestCase(0)]
    [TestCase(30 * 86_400)]
    public void LateUpdate_AfterDays_UpdatesAtTheRefreshInterval(double start)
    {
        _played.Panel.With("_refreshSeconds", 0.1f);
        _played.Session.gameObject.SetActive(true);
        var distances = new HashSet<float?>();

        // The viewer moves away, so that each update changes the distance.
        for (var frame = 1; frame <= 60; frame++)
        {
            _played.Camera.transform.position = new Vector3(0, 0, 2 - MathF.Pow(1.12f, frame));
            _played.Cell.Player.Step(start + frame / 60.0);
            distances.Add(_played.Panel.LegibleMetres);
        }

        Assert.That(distances, Has.Count.InRange(9, 11));
    }

    [TestCase(1)]
    [TestCase(2)]
    [TestCase(5)]
    public void LateUpdate_ViewerAtADistance_LettersAreLegible(float metres)
    {
        _played.Panel.transform.position = new Vector3(0, 0, metres);

        _played.Play(1);

        var text = _played.Texts[0];
        var height = 1409 / 2048.0 * 0.1 * text.fontSize * text.characterSize * text.transform.lossyScale.y;
        Assert.That(2 * Math.Atan(height / 2 / metres) * 180 / Math.PI, Is.InRange(0.5, 0.75));
    }

    [Test]
    public void LateUpdate_RowsAndColumns_DoNotOverlap()
    {
        _played.Play(1);

        var size = _played.Sheet.localScale.x;
        var rows = _played.Texts.Where(t => t.text.Length > 0).Select(t => t.transform.localPosition.y).Distinct().OrderDescending().ToList();
        Assert.That(rows, Has.Count.EqualTo(12), "the message has no text and takes no space");
        Assert.That(rows.Zip(rows.Skip(1), (above, below) => above - below), Is.All.InRange(1.2f, 1.6f), "font sizes");
        Assert.That(_played.Texts.Select(t => t.transform.localPosition.x).Distinct().Count(), Is.EqualTo(3));
        Assert.That(size, Is.EqualTo(_played.Sheet.lossyScale.x).Within(1e-6));
    }

    [Test]
    public void LateUpdate_Message_IsOnTopWithoutMovingTheRows()
    {
        _played.Panel.With("_ground", new Material((Shader)null));
        _played.Play(1);
        var before = (Place("Pose 0"), Place("Base 0"), GroundBounds.min.y, GroundBounds.max.y);

        _played.Session.Settings = null;
        _played.Session.gameObject.SetActive(false);
        _played.Session.gameObject.SetActive(true);
        _played.Run(1);

        Assert.That(_played.Text("Message 0"), Is.Not.Empty);
        Assert.That(Place("Pose 0"), Is.EqualTo(before.Item1).Within(1e-5));
        Assert.That(Place("Base 0"), Is.EqualTo(before.Item2).Within(1e-5));
        Assert.That(GroundBounds.min.y, Is.EqualTo(before.Item3).Within(1e-5), "the lower edge of the panel does not move");
        Assert.That(GroundBounds.max.y, Is.GreaterThan(before.Item4 + 0.01));
        Assert.That(Place("Message 0"), Is.GreaterThan(Place("Pose 0")));
    }

    // The source of the render time is selected after some frames.
    [Test]
    public void LateUpdate_RenderTimeNotMeasured_IsReportedAfterSomeSeconds()
    {
        _played.EachFrame = null;
        _played.Play(4);
        var before = _played.Text("Message 0");

        _played.Run(4);

        Assert.That(before, Is.Empty);
        Assert.That(_played.Text("Message 0"), Is.Not.Empty);
    }

    float Place(string cell) => _played.Sheet.Find(cell).position.y;

    Bounds GroundBounds => _played.Sheet.Find("Ground").GetComponent<MeshRenderer>().bounds;

    [TestCase(1, 1)]
    [TestCase(4, 1)]
    [TestCase(2, 0.5f)]
    [TestCase(2, 3)]
    public void LateUpdate_Bar_IsAtTheLowerEdgeWithTheLettersScale(float metres, float scale)
    {
        var bar = new GameObject("Bar").transform;
        bar.SetParent(_played.Panel.transform, false);
        _played.Panel.With("_ground", new Material((Shader)null)).With("_bar", bar);
        _played.Panel.transform.position = new Vector3(0, 0, metres);
        _played.Session.transform.localScale = new Vector3(7, 7, 7);
        _played.Panel.transform.localScale = Vector3.one * scale;

        _played.Play(1);

        Assert.That(bar.position.y, Is.EqualTo(GroundBounds.min.y).Within(1e-4));
        Assert.That(bar.lossyScale.x, Is.EqualTo(_played.Sheet.lossyScale.x).Within(1e-6));
        Assert.That(
            _played.Sheet.lossyScale.x, Is.EqualTo(scale * LetterSize.At(_played.Panel.LegibleMetres.Value)).Within(1e-5), "as the user scaled it");
    }

    [Test]
    public void LateUpdate_UserScalesThePanel_KeepsTheBarAtTheLowerEdge()
    {
        var bar = new GameObject("Bar").transform;
        bar.SetParent(_played.Panel.transform, false);
        _played.Panel.With("_ground", new Material((Shader)null)).With("_bar", bar);
        _played.Play(1);

        _played.Panel.transform.localScale = Vector3.one * 2;

        Assert.That(bar.position.y, Is.EqualTo(GroundBounds.min.y).Within(1e-4), "in the same frame");
        Assert.That(bar.lossyScale.x, Is.EqualTo(_played.Sheet.lossyScale.x).Within(1e-6));
    }
}
