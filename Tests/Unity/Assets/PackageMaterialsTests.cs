using System.Text.RegularExpressions;
using Nowpose.Unity;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>
/// Tests that prefabs and scenes use only materials of the package, and that their render order does not hide parts that must be visible.
/// </summary>
public sealed class PackageMaterialsTests
{
    const string Materials = RepositoryFiles.Package + "/Runtime/Materials/";

    AssetLibrary _library;

    /// <summary>Prefabs, scenes, materials and assets of the package and of the host project, without stand-ins for other packages.</summary>
    static IEnumerable<string> Files => RepositoryFiles.All
        .Where(f => f.StartsWith("Packages/", StringComparison.Ordinal) || f.StartsWith("Assets/", StringComparison.Ordinal))
        .Where(f => Path.GetExtension(f) is ".prefab" or ".unity" or ".mat" or ".asset");

    static IEnumerable<string> Hierarchies => Files.Where(f => Path.GetExtension(f) is ".prefab" or ".unity");

    [SetUp]
    public void SetUp() => _library = RepositoryAssets.NewLibrary();

    GameObject[] Roots(string path) =>
        Path.GetExtension(path) == ".unity" ? _library.LoadScene(path).Roots.ToArray() : [_library.Load<GameObject>(path)];

    IEnumerable<T> All<T>(string path)
        where T : Component => Roots(path).SelectMany(r => r.GetComponentsInChildren<T>(true));

    Material Load(string name) => _library.Load<Material>(Materials + name + ".mat");

    /// <summary>URP draws the built-in default material (10303) and the Standard shader (46) in magenta.</summary>
    [TestCaseSource(nameof(Files))]
    public void File_References_ExcludeBuiltInMaterials(string path)
    {
        var text = RepositoryFiles.Read(path);

        Assert.That(Regex.Matches(text, @"fileID: 10303\b|fileID: 46, guid: 0000000000000000f"), Is.Empty);
        Assert.That(Regex.Matches(text, @"guid: 0000000000000000f000000000000000"), Is.Empty, "the file uses none of Unity's extra resources");
    }

    [TestCaseSource(nameof(Hierarchies))]
    public void Renderer_Materials_BelongToThePackage(string path)
    {
        var materials = All<Renderer>(path).SelectMany(r => r.sharedMaterials).ToList();

        Assert.That(materials.Where(m => !m.shader.name.StartsWith("Nowpose/", StringComparison.Ordinal)).Select(m => m.name), Is.Empty);
    }

    [TestCaseSource(nameof(Hierarchies))]
    public void TextMesh_Material_TestsDepthAndHasTheFontTexture(string path)
    {
        foreach (var text in All<TextMesh>(path))
        {
            Assert.That(text.GetComponent<MeshRenderer>().sharedMaterial, Is.SameAs(Load("Text")), text.name);
            Assert.That(text.GetComponent<FontTexture>(), Is.Not.Null, text.name);
        }
        foreach (var renderer in All<Renderer>(path).Where(r => !r.TryGetComponent<TextMesh>(out _)))
            Assert.That(renderer.sharedMaterial.shader.name, Is.Not.EqualTo("Nowpose/Text"), renderer.name);
    }

    [TestCaseSource(nameof(Hierarchies))]
    public void PoseAppearance_Substitute_IsAssigned(string path)
    {
        foreach (var appearance in All<PoseAppearance>(path))
        {
            var isGhost = appearance.GetComponent<Ghost>() != null
                || (appearance.TryGetComponent<TrackedObject>(out var tracked) && tracked.Shows == RigPose.Held);

            Assert.That(appearance.Shown("_substitute"), Is.SameAs(Load(isGhost ? "Ghost" : "Hologram")), appearance.name);
            Assert.That(appearance.NeedsSubstitute, Is.False, "the package's own materials can show the state");
        }
    }

    /// <summary>The ghost writes depth, so it must be drawn after all parts that it must not hide.</summary>
    [Test]
    public void GhostMaterial_RenderQueue_IsAfterOtherVirtualParts(
        [Values("Hologram", "Arm", "Timestamp", "Text", "Backdrop", "Panel", "Solid", "Occluder")] string other)
    {
        Assert.That(Load("Ghost").renderQueue, Is.GreaterThan(Load(other).renderQueue));
    }

    /// <summary>
    /// The panel's background is drawn before the virtual parts. If it wrote depth, the parts behind it would not be drawn at all. All other parts need
    /// depth, because late-stage reprojection stabilises a part by its depth.
    /// </summary>
    [TestCase("Backdrop", 0)]
    [TestCase("Arm", 1)]
    [TestCase("Ghost", 1)]
    [TestCase("Hologram", 1)]
    [TestCase("Panel", 1)]
    [TestCase("Solid", 1)]
    [TestCase("Timestamp", 1)]
    [TestCase("Workpiece", 1)]
    public void Material_Depth_IsWrittenExceptByTheBackdrop(string name, int depth)
    {
        Assert.That(Load(name).HasProperty("_ZWrite"));
        Assert.That(Load(name).GetFloat("_ZWrite"), Is.EqualTo(depth));
    }

    [TestCase("Occluder", 1990)]
    [TestCase("Solid", 2000)]
    [TestCase("Backdrop", 2900)]
    [TestCase("Panel", 2900)]
    [TestCase("Hologram", 3000)]
    [TestCase("Text", 3000)]
    [TestCase("Ghost", 3100)]
    public void Material_Queue_MatchesTheManual(string name, int queue)
    {
        Assert.That(Load(name).renderQueue, Is.EqualTo(queue));
        Assert.That(RepositoryFiles.Read(RepositoryFiles.Package + "/Documentation~/shaders.md"),
            Does.Match($@"`{name}` {queue}|Text Meshes {queue}"));
    }
}
