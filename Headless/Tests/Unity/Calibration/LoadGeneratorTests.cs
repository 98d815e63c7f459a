using Nowpose.Latency;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Nowpose.Headless.Tests.Unity.Calibration;

public sealed class LoadGeneratorTests
{
    PlayedCell _cell;
    LoadGenerator _load;

    [SetUp]
    public void Begin() => _cell = new PlayedCell();

    [TearDown]
    public void End() => _cell.Dispose();

    void Play(int vertices = 0, int? verticesPerFrame = null)
    {
        var wall = new GameObject("Load");
        wall.SetActive(false);
        _load = wall.AddComponent<LoadGenerator>().With("_material", new Material((Shader)null)).With("_vertices", vertices);
        if (verticesPerFrame is int number) _load.With("_verticesPerFrame", number);
        wall.SetActive(true);
    }

    /// <returns>Frames that it took.</returns>
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
    public void Vertices_Set_AreAllDrawnAfterAWhile(int vertices)
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
    public void Vertices_MoreThanCanBe_AreRefusedAndTheLoadStays()
    {
        Play(50_000);
        Build();

        Assert.That(() => _load.Vertices = 2_000_001, Throws.TypeOf<InputException>().With.Message.EqualTo(
            "load, vertices: 2000001 is out of range; allowed are 0 to 2000000"));
        _cell.Frame(null);

        Assert.That(_load.VerticesShown, Is.EqualTo(50_000));
    }

    // What is drawn grows by what was handed over, so a frame's work is known from it.
    [TestCase(LoadMesh.GreatestVertices, LoadMesh.PatchVertices)]
    [TestCase(600_000, 3 * LoadMesh.PatchVertices)]
    [TestCase(200_000, 1)]
    public void Building_OfALoad_KeepsToItsBudgetInEveryFrame(int vertices, int budget)
    {
        Play(vertices, budget);
        var most = 0;
        var frames = 0;

        for (var before = 0; !_load.IsReady && frames < 1000; frames++)
        {
            _cell.Frame(null);
            most = Math.Max(most, _load.VerticesShown - before);
            before = _load.VerticesShown;
        }

        var allowed = Math.Max(budget, LoadMesh.PatchVertices);
        Assert.That(most, Is.InRange(1, allowed));
        Assert.That(frames, Is.EqualTo(Math.Ceiling(2.0 * vertices / allowed)).Within(1), "computed once, handed over once");
    }

    [Test]
    public void Load_GoneBackTo_IsThereAtOnce()
    {
        Play(400_000);
        Build();
        _load.Vertices = 200_000;
        Assert.That(Build(), Is.EqualTo(1));

        _load.Vertices = 400_000;

        Assert.That(Build(), Is.EqualTo(1));
        Assert.That(_load.GetComponentsInChildren<MeshRenderer>(), Has.Length.EqualTo(16), "nothing was made anew");
    }

    [Test]
    public void Load_ChangedWhileItIsBuilt_IsTheNewOne()
    {
        Play(1_000_000);
        for (var i = 0; i < 7; i++) _cell.Frame(null);

        _load.Vertices = 30_000;
        Build();

        Assert.That(Shown.Select(mesh => mesh.vertexCount), Is.EquivalentTo(new[] { 25_000, 5_000 }));
    }

    [Test]
    public void Frames_WithALoadThatStays_AllocateNothing()
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
    public void Disabled_LeavesNothing()
    {
        Play(200_000);
        Build();
        var meshes = Shown;

        _load.enabled = false;
        _cell.Frame(null);

        Assert.That(meshes, Has.All.Matches<Mesh>(mesh => !mesh), "destroyed");
        Assert.That(_load.transform.childCount, Is.Zero);
        Assert.That(_load.VerticesShown, Is.Zero);
        Assert.That(_load.IsReady, Is.False);

        _load.enabled = true;
        Build();
        Assert.That(_load.VerticesShown, Is.EqualTo(200_000));
    }

    [Test]
    public void Material_Missing_IsSaidOnce()
    {
        var load = new GameObject("Load").AddComponent<LoadGenerator>();

        _cell.Frame(null);
        _cell.Frame(null);

        Assert.That(load.Problem, Is.EqualTo("load generator 'Load' has no material to draw with; assign one"));
        Assert.That(_cell.Messages.Count(m => m.Contains("no material", StringComparison.Ordinal)), Is.EqualTo(1));
    }
}
