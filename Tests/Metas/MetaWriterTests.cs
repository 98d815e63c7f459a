using Nowpose.Metas;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Metas;

public sealed class MetaWriterTests
{
    MetaProjectFolder _project;

    [SetUp]
    public void SetUp() => _project = new MetaProjectFolder();

    [TearDown]
    public void TearDown() => _project.Dispose();

    [Test]
    public void WriteMissing_AssetsPackagesAndSamples_WritesAMetaForEachFileAndFolder()
    {
        _project.Add("Assets/Scenes/Demo.unity");
        _project.Add("Packages/com.x/package.json");
        _project.Add("Packages/com.x/Runtime/A.cs");
        _project.Add("Packages/com.x/Samples~/Demo/Scenes/Demo.unity");

        MetaWriter.WriteMissing(_project.Root);

        Assert.That(_project.Metas(), Is.EqualTo(new[]
        {
            "Assets/Scenes.meta",
            "Assets/Scenes/Demo.unity.meta",
            "Packages/com.x/Runtime.meta",
            "Packages/com.x/Runtime/A.cs.meta",
            "Packages/com.x/Samples~/Demo/Scenes.meta",
            "Packages/com.x/Samples~/Demo/Scenes/Demo.unity.meta",
            "Packages/com.x/package.json.meta",
        }));
    }

    [TestCase("Assets/.hidden/a.cs")]
    [TestCase("Assets/.a.cs")]
    [TestCase("Assets/Old~/a.cs")]
    [TestCase("Assets/a.cs~")]
    [TestCase("Assets/a.tmp")]
    [TestCase("Assets/cvs/a.cs")]
    [TestCase("Packages/com.x/Documentation~/a.md")]
    [TestCase("Gateway/a.cs")]
    public void WriteMissing_HiddenFileOrOtherFolder_WritesNoMeta(string path)
    {
        _project.Add(path);

        MetaWriter.WriteMissing(_project.Root);

        Assert.That(_project.Metas(), Is.Empty);
    }

    [Test]
    public void WriteMissing_EmptyFolder_WritesNoMeta()
    {
        Directory.CreateDirectory(Path.Combine(_project.Root, "Assets", "Empty", "Nested"));

        MetaWriter.WriteMissing(_project.Root);

        Assert.That(_project.Metas(), Is.Empty);
    }

    [Test]
    public void WriteMissing_SecondRun_ChangesNothing()
    {
        _project.Add("Assets/A.cs");
        MetaWriter.WriteMissing(_project.Root);
        var first = _project.Read("Assets/A.cs.meta");

        var written = MetaWriter.WriteMissing(_project.Root);

        Assert.That(written, Is.Empty);
        Assert.That(_project.Read("Assets/A.cs.meta"), Is.EqualTo(first));
    }

    [Test]
    public void WriteMissing_SamePathInAnotherProject_WritesTheSameGuid()
    {
        using var other = new MetaProjectFolder();
        _project.Add("Assets/A.cs");
        other.Add("Assets/A.cs", "class A { }");

        MetaWriter.WriteMissing(_project.Root);
        MetaWriter.WriteMissing(other.Root);

        Assert.That(other.Read("Assets/A.cs.meta"), Is.EqualTo(_project.Read("Assets/A.cs.meta")));
    }

    [Test]
    public void WriteMissing_FirstGuidOfThePathInUse_WritesAnotherGuid()
    {
        _project.Add("Assets/A.cs");
        MetaWriter.WriteMissing(_project.Root);
        _project.Add("Assets/B.cs");
        _project.Add("Assets/B.cs.meta", _project.Read("Assets/A.cs.meta"));
        _project.Delete("Assets/A.cs.meta");

        MetaWriter.WriteMissing(_project.Root);

        Assert.That(MetaCheck.Faults(_project.Root), Is.Empty);
    }

    [Test]
    public void Prune_AssetDeleted_RemovesOnlyItsMeta()
    {
        _project.Add("Assets/A.cs");
        _project.Add("Assets/B.cs");
        MetaWriter.WriteMissing(_project.Root);
        _project.Delete("Assets/A.cs");

        var removed = MetaWriter.Prune(_project.Root);

        Assert.That(removed, Is.EqualTo(new[] { "Assets/A.cs.meta" }));
        Assert.That(_project.Metas(), Is.EqualTo(new[] { "Assets/B.cs.meta" }));
    }
}
