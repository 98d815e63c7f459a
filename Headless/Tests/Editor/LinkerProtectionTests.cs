using System.Xml.Linq;
using Nowpose.Editor;
using Nowpose.Headless.Tests.Repository;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.UnityLinker;

namespace Nowpose.Headless.Tests.Editor;

public sealed class LinkerProtectionTests : EditorFixture
{
    [Test]
    public void Generate_InAnyProject_WritesALinkXmlAndGivesItsAbsolutePath()
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
    public void Generate_Content_KeepsAssembliesOfThePackageWhole()
    {
        using var folder = new ProjectFolder();
        folder.Write("Packages/manifest.json", "{}");
        Project.Open(folder.Root);

        var path = Project.InRoot(() => new LinkerProtection().GenerateAdditionalLinkXmlFile(null, null));

        var kept = XDocument.Load(path).Root.Elements("assembly").ToList();
        var ours = RepositoryFiles.Under(RepositoryFiles.Package + "/Runtime", ".asmdef").Select(Path.GetFileNameWithoutExtension);
        Assert.That(kept.Select(e => (string)e.Attribute("fullname")), Is.EqualTo(new[] { "Nowpose.Unity" }).And.SubsetOf(ours));
        Assert.That(kept.Select(e => (string)e.Attribute("preserve")), Is.All.EqualTo("all"));
    }
}
