using System.Reflection;
using Nowpose.Editor;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Manual;

/// <summary>Tests that lists in the documents are complete.</summary>
public sealed class ListedPartsTests
{
    static readonly string[] Runtime =
    [
        "Nowpose", "Nowpose.Unity", "Nowpose.ArFoundation", "Nowpose.MRTK3", "Nowpose.OpenXR", "Nowpose.OpenXR.Anchoring",
    ];

    [Test]
    public void Readme_TableOfNamespaces_HasEachNamespaceWithPublicTypes()
    {
        var table = RepositoryFiles.Read(RepositoryFiles.Package + "/README.md").Split('\n')
            .SkipWhile(line => line != "| namespace | contents |").Skip(2).TakeWhile(line => line.StartsWith('|'))
            .SelectMany(row => row.Split('|')[1].Split(',')).Select(name => name.Trim(' ', '`'));
        var used = Runtime.SelectMany(name => Assembly.Load(name).GetExportedTypes()).Select(type => type.Namespace).Distinct();

        Assert.That(table, Is.EquivalentTo(used), "correct the table of namespaces in the package's README.md");
    }

    [Test]
    public void Readme_OwnAssembly_NamesEachAssemblyWithComponents()
    {
        var readme = RepositoryFiles.Read(RepositoryFiles.Package + "/README.md");
        var section = readme[readme.IndexOf("### Scripts in your own assembly", StringComparison.Ordinal)..];

        Assert.That(Runtime.Where(name => !section.Contains('`' + name + '`', StringComparison.Ordinal)), Is.Empty, "name them in README.md");
    }

    [TestCase("project-setup.md")]
    [TestCase("prefabs.md")]
    public void Page_PartsOfACell_AreThoseOfTheMenu(string page)
    {
        var text = RepositoryFiles.Read(RepositoryFiles.Package + "/Documentation~/" + page).Replace('\n', ' ');

        Assert.That(
            CellMenu.Entries.Select(entry => entry.Name).Where(name => !text.Contains(name, StringComparison.Ordinal)), Is.Empty,
            $"{page} must name these entries of the menu");
    }
}
