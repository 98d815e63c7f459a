using System.Xml.Linq;
using Nowpose.Editor;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.UnityLinker;

namespace Nowpose.Unity.Tests.Editor;

public sealed class LinkerProtectionTests : EditorFixture
{
    [Test]
    public void Generate_AnyProject_WritesALinkXmlAndReturnsItsAbsolutePath()
    {
        using var folder = new ProjectFolder();
        folder.Write("Packages/manifest.json", "{}");
        Project.Open(folder.Root);

        var path = Project.InRoot(() => new LinkerProtection().GenerateAdditionalLinkXmlFile(
            null, new UnityLinkerBuildPipelineData(BuildTarget.WSAPlayer, folder.Root)));

        Assert.That(Path.IsPathRooted(path));
        Assert.That(path, Does.StartWith(Path.Combine(folder.Root, "Temp")));
        Assert.That(XDocument.Load(path).Root.Name.LocalName, Is.EqualTo("linker"));
    }

    [Test]
    public void Generate_AnyProject_PreservesTheListedAssemblies()
    {
        using var folder = new ProjectFolder();
        folder.Write("Packages/manifest.json", "{}");
        Project.Open(folder.Root);

        var path = Project.InRoot(() => new LinkerProtection().GenerateAdditionalLinkXmlFile(null, null));

        var kept = XDocument.Load(path).Root.Elements("assembly").ToList();
        var ours = RepositoryFiles.Under(RepositoryFiles.Package + "/Runtime", ".asmdef").Select(Path.GetFileNameWithoutExtension);
        Assert.That(kept.Select(e => (string)e.Attribute("fullname")), Does.Contain("Nowpose.Unity").And.SubsetOf(ours));
        Assert.That(kept.Select(e => (string)e.Attribute("preserve")), Is.Not.Empty.And.All.EqualTo("all"));
    }

    [Test]
    public void Generate_AssembliesWithComponents_ArePreserved()
    {
        using var folder = new ProjectFolder();
        folder.Write("Packages/manifest.json", "{}");
        Project.Open(folder.Root);

        var path = Project.InRoot(() => new LinkerProtection().GenerateAdditionalLinkXmlFile(null, null));

        var kept = XDocument.Load(path).Root.Elements("assembly").ToDictionary(
            e => (string)e.Attribute("fullname"), e => (string)e.Attribute("ignoreIfMissing") == "1");
        var definitions = RepositoryFiles.Under(RepositoryFiles.Package + "/Runtime", ".asmdef").ToArray();
        Assert.That(definitions, Is.Not.Empty);
        foreach (var definition in definitions)
        {
            var folderOfIt = definition[..(definition.LastIndexOf('/') + 1)];
            var hasComponents = RepositoryFiles.Under(folderOfIt.TrimEnd('/'), ".cs").Any(f => RepositoryFiles.Read(f).Contains("[AddComponentMenu("));
            var isOptional = !RepositoryFiles.Read(definition).Contains("\"defineConstraints\": []");
            var name = Path.GetFileNameWithoutExtension(definition);

            Assert.That(kept.ContainsKey(name), Is.EqualTo(hasComponents), name + ": LinkerProtection.cs must list exactly the assemblies with components");
            if (hasComponents) Assert.That(kept[name], Is.EqualTo(isOptional), name + ": ignoreIfMissing belongs to assemblies for optional packages");
        }
    }
}
