using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

public sealed class VersionTests
{
    static readonly string Version = JsonDocument.Parse(RepositoryFiles.Read(RepositoryFiles.Package + "/package.json"))
        .RootElement.GetProperty("version").GetString();

    [TestCase("Directory.Build.props", @"<Version>([^<]+)</Version>")]
    [TestCase("CITATION.cff", @"(?m)^version: (.+)$")]
    [TestCase("Web/package.json", @"""version"": ""([^""]+)""")]
    [TestCase("Web/package-lock.json", @"""version"": ""([^""]+)""")]
    [TestCase("Vision/package.json", @"""version"": ""([^""]+)""")]
    [TestCase("Vision/package-lock.json", @"""version"": ""([^""]+)""")]
    [TestCase("Gateway/Adapters/package.json", @"""version"": ""([^""]+)""")]
    [TestCase("Gateway/Adapters/package-lock.json", @"""version"": ""([^""]+)""")]
    [TestCase(RepositoryFiles.Package + "/Runtime/Core/NowposeVersion.cs", @"Text = ""([^""]+)""")]
    [TestCase(RepositoryFiles.Package + "/README.md", @"Assets/Samples/Nowpose/([^/]+)/")]
    [TestCase("CHANGELOG.md", @"(?m)^## \[([^\]]+)\]")]
    [TestCase(RepositoryFiles.Package + "/CHANGELOG.md", @"(?m)^## \[([^\]]+)\]")]
    public void Version_EveryPlace_MatchesThePackage(string path, string pattern)
    {
        var match = Regex.Match(RepositoryFiles.Read(path), pattern);

        Assert.That(match.Groups[1].Value, Is.EqualTo(Version));
    }

    [Test]
    public void Workflow_UnityJob_UsesTheProjectsEditor()
    {
        var editor = Regex.Match(RepositoryFiles.Read("ProjectSettings/ProjectVersion.txt"), @"m_EditorVersion: (\S+)").Groups[1].Value;

        var image = Regex.Match(RepositoryFiles.Read(".github/workflows/tests.yml"), @"unityci/editor:ubuntu-([^-]+)-base").Groups[1].Value;

        Assert.That(image, Is.EqualTo(editor).And.Not.Empty);
    }

    // The owner of an action can move its tag to other code, which would run with the rights to publish a release.
    [Test]
    public void Workflows_Actions_ArePinnedToACommit()
    {
        var actions = RepositoryFiles.All.Where(path => path.StartsWith(".github/workflows/", StringComparison.Ordinal))
            .SelectMany(path => RepositoryFiles.Read(path).Split('\n')).Where(line => line.Contains("uses:")).ToArray();

        Assert.That(actions, Is.Not.Empty.And.All.Match(@"uses: \S+@[0-9a-f]{40} # v\d+\.\d+\.\d+$"));
    }
}
