using Nowpose.Latency;
using Nowpose.Latency.Load;
using Nowpose.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Nowpose.Unity.Tests.Calibration;

public sealed class LoadGeneratorTests
{
    PlayedCell _cell;
    LoadGenerator _load;

    [SetUp]
    public void Begin() => _cell = new PlayedCell();

    [TearDown]
    public void End() => _cell.Dispose();

    // Simulated duration of a building step in ms: each reading of the clock advances it by this time.
    const double StepMs = 0.5;

    void Play(int vertices = 0, float? msPerFrame = null)
    {
        var session = _cell.NewSession();
        _cell.Clock.Step = TimeSpan.FromMilliseconds(StepMs);
        var wall = new GameObject("Load");
        wall.transform.SetParent(session.transform, worldPositionStays: false);
        wall.SetActive(false);
        session.gameObject.SetActive(true);
        _load = wall.AddComponent<LoadGenerator>().With("_material", new Material((Shader)null)).With("_vertices", vertices);
        if (msPerFrame is float ms) _load.With("_msPerFrame", ms);
        wall.SetActive(true);
    }

    /// <summary>Runs frames until the load is built.</summary>
    /// <returns>Number of frames.</returns>
    int Build()
    {
        var frames = 0;
        do _cell.Frame(null);
        while (!_load.IsReady && ++frames < 1000);
        return frames + 1;
    }

    List<Mesh> Shown => [.. _load.GetComponentsInChildren<MeshRenderer>().Where(r => r.enabled).Select(r => r.GetComponent<MeshFilter>().sharedMesh)];

    [TestCase(0)]
    [TestCase(3)]
    [TestCase(300_004)]
    public void Vertices_Set_AreAllDrawnAfterSomeFrames(int vertices)
    {
        Play();
        _load.Vertices = vertices;
        Assert.That(_load.IsReady, Is.EqualTo(vertices == 0));

        Build();

        Assert.That(_load.VerticesShown, Is.EqualTo(vertices));
        Assert.That(Shown.Sum(mesh => mesh.vertexCount), Is.EqualTo(vertices));
        Assert.That(Shown, Has.All.Matches<Mesh>(mesh => mesh.indexFormat == IndexFormat.UInt32 && !mesh.IsReadable && mesh.bounds.size.x > 0));
    }

    [Test]
    public void Vertices_OutOfRange_ThrowsAndKeepsTheLoad()
    {
        Play(50_000);
        Build();

        Assert.That(() => _load.Vertices = 2_000_001, Throws.TypeOf<InputException>().With.Message.EqualTo(
            SettingMessages.OutOfRange("load, vertices", 2_000_001, "", 0, 2_000_000)));
        _cell.Frame(null);

        Assert.That(_load.VerticesShown, Is.EqualTo(50_000));
    }

    // Runs a frame and returns the time in ms by which the clock has advanced.
    double FrameMs()
    {
        _cell.Frame(null);
        return (_cell.Clock.Read - HeadsetTime.FromSeconds(1000 + _cell.Now)).TotalMilliseconds;
    }

    [TestCase(LoadMesh.MaxVertices, 2f)]
    [TestCase(600_000, 10f)]
    [TestCase(100_000, 0.1f, TestName = "Update_StepLongerThanTheTimePerFrame_TakesOneStepPerFrame")]
    public void Update_BuildingALoad_StaysWithinTheTimeBudgetPerFrame(int vertices, float msPerFrame)
    {
        Play(0, msPerFrame);
        var without = Enumerable.Range(0, 10).Max(_ => FrameMs());
        _load.Vertices = vertices;
        var frames = new List<double>();

        while (!_load.IsReady && frames.Count < 5000) frames.Add(FrameMs() - without);

        Assert.That(_load.VerticesShown, Is.EqualTo(vertices));
        // The second StepMs allows for the reading of the clock before the first step.
        Assert.That(frames.Max(), Is.LessThanOrEqualTo(Math.Max(msPerFrame, StepMs) + StepMs + 1e-3));
        Assert.That(frames.Skip(frames.Count / 2).Average(), Is.GreaterThan(0.6 * msPerFrame), "the time is used");
    }

    [Test]
    public void Load_BuiltEarlier_IsShownImmediately()
    {
        Play(400_000);
        Build();
        _load.Vertices = 200_000;
        Assert.That(Build(), Is.EqualTo(1));

        _load.Vertices = 400_000;

        Assert.That(Build(), Is.EqualTo(1));
        Assert.That(_load.GetComponentsInChildren<MeshRenderer>(), Has.Length.EqualTo(16), "the objects are reused");
    }

    [Test]
    public void Load_ChangedWhileBuilding_BuildsTheNewLoad()
    {
        Play(1_000_000);
        for (var i = 0; i < 7; i++) _cell.Frame(null);

        _load.Vertices = 30_000;
        Build();

        Assert.That(Shown.Select(mesh => mesh.vertexCount), Is.EquivalentTo(new[] { 25_000, 5_000 }));
    }

    [Test]
    public void Frames_WithAConstantLoad_AllocateNothing()
    {
        Play(200_000);
        Build();
        for (var i = 0; i < 60; i++) _cell.Frame(null);

        var allocated = _cell.AllocatedIn(() =>
        {
            for (var i = 0; i < 600; i++) _cell.Frame(null);
        });

        Assert.That(allocated, Is.Zero);
    }

    [Test]
    public void OnDisable_WhileShown_RemovesItsObjects()
    {
        Play(200_000);
        Build();
        var meshes = Shown;

        _load.enabled = false;
        _cell.Frame(null);

        Assert.That(meshes, Is.Not.Empty.And.All.Matches<Mesh>(mesh => !mesh), "destroyed");
        Assert.That(_load.transform.childCount, Is.Zero);
        Assert.That(_load.VerticesShown, Is.Zero);
        Assert.That(_load.IsReady, Is.False);

        _load.enabled = true;
        Build();
        Assert.That(_load.VerticesShown, Is.EqualTo(200_000));
    }

    [Test]
    public void Material_Missing_IsLoggedOnce()
    {
        var load = new GameObject("Load").AddComponent<LoadGenerator>();

        _cell.Frame(null);
        _cell.Frame(null);

        Assert.That(load.Problem, Is.EqualTo("load generator 'Load' " + ComponentMessages.NoMaterial));
        Assert.That(_cell.Messages.Count(m => m.Contains(ComponentMessages.NoMaterial, StringComparison.Ordinal)), Is.EqualTo(1));
    }
}
