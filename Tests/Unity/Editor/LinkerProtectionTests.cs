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

        var kept = WholeAssemblies(path);
        var ours = RepositoryFiles.Under(RepositoryFiles.Package + "/Runtime", ".asmdef").Select(Path.GetFileNameWithoutExtension);
        Assert.That(kept.Select(e => (string)e.Attribute("fullname")), Does.Contain("Nowpose.Unity").And.SubsetOf(ours));
        Assert.That(kept.Select(e => (string)e.Attribute("preserve")), Is.Not.Empty.And.All.EqualTo("all"));
    }

    [TestCase("System.Configuration", "type", "System.Configuration.ExeConfigurationHost")]
    [TestCase("System", "namespace", "System.Net.Configuration")]
    public void Generate_AnyProject_PreservesTypesThatMonoCreatesByName(string assembly, string kind, string name)
    {
        using var folder = new ProjectFolder();
        folder.Write("Packages/manifest.json", "{}");
        Project.Open(folder.Root);

        var path = Project.InRoot(() => new LinkerProtection().GenerateAdditionalLinkXmlFile(null, null));

        var listed = XDocument.Load(path).Root.Elements("assembly").SingleOrDefault(e => (string)e.Attribute("fullname") == assembly);
        Assert.That(listed, Is.Not.Null);
        Assert.That((string)listed.Attribute("ignoreIfMissing"), Is.EqualTo("1"), "IL2CPP builds may lack it");
        var kept = listed.Elements(kind).Single();
        Assert.That(((string)kept.Attribute("fullname"), (string)kept.Attribute("preserve")), Is.EqualTo((name, "all")));
    }

    [Test]
    public void Generate_AssembliesWithComponents_ArePreserved()
    {
        using var folder = new ProjectFolder();
        folder.Write("Packages/manifest.json", "{}");
        Project.Open(folder.Root);

        var path = Project.InRoot(() => new LinkerProtection().GenerateAdditionalLinkXmlFile(null, null));

        var kept = WholeAssemblies(path).ToDictionary(
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

    static List<XElement> WholeAssemblies(string path) => XDocument.Load(path).Root.Elements("assembly").Where(e => !e.HasElements).ToList();
}
