using Nowpose.Metas;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Metas;

public sealed class MetaCheckTests
{
    MetaProjectFolder _project;

    [SetUp]
    public void SetUp()
    {
        _project = new MetaProjectFolder();
        _project.Add("Assets/Folder/A.cs");
        _project.Add("Packages/com.x/package.json", "{}");
        MetaWriter.WriteMissing(_project.Root);
    }

    [TearDown]
    public void TearDown() => _project.Dispose();

    [Test]
    public void Faults_AllMetasWritten_AreEmpty()
    {
        Assert.That(MetaCheck.Faults(_project.Root), Is.Empty);
    }

    [Test]
    public void Faults_MetaMissing_NamesTheFile()
    {
        _project.Add("Assets/B.cs");

        ExpectOneFault("Assets/B.cs: has no .meta");
    }

    [Test]
    public void Faults_MetaWithoutAsset_NamesTheMeta()
    {
        _project.Delete("Assets/Folder/A.cs");
        _project.Add("Assets/Folder/B.txt");
        MetaWriter.WriteMissing(_project.Root);

        ExpectOneFault("Assets/Folder/A.cs.meta: its asset does not exist");
    }

    [Test]
    public void Faults_SameGuidTwice_NamesBoth()
    {
        _project.Add("Assets/B.cs");
        _project.Add("Assets/B.cs.meta", _project.Read("Assets/Folder/A.cs.meta"));

        var guid = new MetaFile(_project.Read("Assets/B.cs.meta")).AssetGuid;
        ExpectOneFault($"Assets/Folder/A.cs.meta: guid {guid} is also that of Assets/B.cs.meta");
    }

    [Test]
    public void Faults_WrongImporter_NamesTheCorrectImporter()
    {
        _project.Replace("Assets/Folder/A.cs.meta", "MonoImporter", "DefaultImporter");

        ExpectOneFault("Assets/Folder/A.cs.meta: importer is DefaultImporter, MonoImporter is needed");
    }

    [Test]
    public void Faults_FolderAssetMissing_NamesTheFolder()
    {
        _project.Replace("Assets/Folder.meta", "folderAsset: yes\n", "");

        ExpectOneFault("Assets/Folder.meta: folder without folderAsset: yes");
    }

    [Test]
    public void Faults_InvalidGuid_NamesTheFile()
    {
        _project.Replace("Assets/Folder.meta", "guid: ", "guid: x");

        ExpectOneFault("Assets/Folder.meta: has no guid");
    }

    [TestCase("Assets/A.csproj", "Assets/A.csproj")]
    [TestCase("Packages/com.x/A.sln", "Packages/com.x/A.sln")]
    [TestCase("Packages/com.x/A.slnx", "Packages/com.x/A.slnx")]
    [TestCase("Packages/com.x/bin/A.dll", "Packages/com.x/bin")]
    [TestCase("Packages/com.x/obj/A.json", "Packages/com.x/obj")]
    public void Faults_BuildFileInAssets_NamesTheFile(string path, string named)
    {
        _project.Add(path);

        ExpectOneFault(named + ": a .NET build file");
    }

    [Test]
    public void Faults_ThisRepository_AreEmpty()
    {
        var root = ProjectRoot.Find(TestContext.CurrentContext.TestDirectory);

        Assert.That(root, Is.Not.Null, "the tests run inside the repository");
        Assert.That(new AssetTree(root).Assets.Count, Is.GreaterThan(10));
        Assert.That(MetaCheck.Faults(root), Is.Empty, "run: dotnet run --project Headless/Tools/Metas");
    }

    [Test]
    public void Find_FolderInsideAProject_ReturnsTheProject()
    {
        Assert.That(ProjectRoot.Find(Path.Combine(_project.Root, "Assets", "Folder")), Is.EqualTo(_project.Root));
    }

    void ExpectOneFault(string beginning)
    {
        var faults = MetaCheck.Faults(_project.Root);

        Assert.That(faults.Count, Is.EqualTo(1), string.Join('\n', faults));
        Assert.That(faults[0], Does.StartWith(beginning));
    }
}
