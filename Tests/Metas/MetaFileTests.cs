using Nowpose.Metas;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Metas;

public sealed class MetaFileTests
{
    const string Guid = "0123456789abcdef0123456789abcdef";

    [Test]
    public void Format_Script_EqualsUnitysOutput()
    {
        var text = MetaFile.Format(new AssetEntry("Assets/A.cs", IsFolder: false), Guid);

        Assert.That(text, Is.EqualTo(
            "fileFormatVersion: 2\nguid: " + Guid + "\nMonoImporter:\n  externalObjects: {}\n  serializedVersion: 2\n"
            + "  defaultReferences: []\n  executionOrder: 0\n  icon: {instanceID: 0}\n"
            + "  userData: \n  assetBundleName: \n  assetBundleVariant: \n"));
    }

    [Test]
    public void Format_Folder_EqualsUnitysOutput()
    {
        var text = MetaFile.Format(new AssetEntry("Assets/A.cs", IsFolder: true), Guid);

        Assert.That(text, Is.EqualTo(
            "fileFormatVersion: 2\nguid: " + Guid + "\nfolderAsset: yes\nDefaultImporter:\n  externalObjects: {}\n"
            + "  userData: \n  assetBundleName: \n  assetBundleVariant: \n"));
    }

    [TestCase("a.asmdef", "AssemblyDefinitionImporter")]
    [TestCase("package.json", "PackageManifestImporter")]
    [TestCase("a.json", "TextScriptImporter")]
    [TestCase("a.md", "TextScriptImporter")]
    [TestCase("a.txt", "TextScriptImporter")]
    [TestCase("a.xml", "TextScriptImporter")]
    [TestCase("a.urdf", "ScriptedImporter")]
    [TestCase("a.prefab", "PrefabImporter")]
    [TestCase("a.unity", "DefaultImporter")]
    [TestCase("a.asset", "NativeFormatImporter")]
    [TestCase("a.mat", "NativeFormatImporter")]
    [TestCase("a.shader", "ShaderImporter")]
    [TestCase("LICENSE", "DefaultImporter")]
    public void ImporterName_FormattedFile_DependsOnTheExtension(string name, string importer)
    {
        var text = MetaFile.Format(new AssetEntry("Assets/" + name, IsFolder: false), Guid);

        Assert.That(new MetaFile(text).ImporterName, Is.EqualTo(importer));
    }

    [TestCase("a.asset", "mainObjectFileID: 11400000")]
    [TestCase("a.mat", "mainObjectFileID: 2100000")]
    [TestCase("a.shader", "preprocessorOverride: 0")]
    public void Format_ImporterWithFields_WritesThem(string name, string field)
    {
        var text = MetaFile.Format(new AssetEntry("Assets/" + name, IsFolder: false), Guid);

        Assert.That(text, Does.Contain("\n  " + field + "\n"));
    }

    [Test]
    public void Format_Urdf_NamesThePackagesImporter()
    {
        var package = Path.Combine(ProjectRoot.Find(TestContext.CurrentContext.TestDirectory), "Packages", "com.nowpose.mril");
        var importer = new MetaFile(File.ReadAllText(Path.Combine(package, "Editor", "UrdfImporter.cs.meta"))).AssetGuid;
        var script = $"\n  script: {{fileID: 11500000, guid: {importer}, type: 3}}\n";

        Assert.That(MetaFile.Format(new AssetEntry("Assets/a.urdf", IsFolder: false), Guid), Does.Contain(script));
        Assert.That(
            Directory.GetFiles(package, "*.urdf.meta", SearchOption.AllDirectories).Select(File.ReadAllText),
            Is.Not.Empty.And.All.Contains(script));
    }

    [TestCase("guid: 0123456789ABCDEF0123456789abcdef\n")]
    [TestCase("guid: 0123\n")]
    [TestCase("")]
    public void AssetGuid_InvalidText_IsNull(string text)
    {
        Assert.That(new MetaFile(text).AssetGuid, Is.Null);
    }

    [Test]
    public void AssetGuid_WindowsLineEndings_ReturnsTheGuid()
    {
        Assert.That(new MetaFile("fileFormatVersion: 2\r\nguid: " + Guid + "\r\n").AssetGuid, Is.EqualTo(Guid));
    }
}
