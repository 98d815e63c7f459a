using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

public sealed class VersionTests
{
    static readonly string Version = JsonDocument.Parse(RepositoryFiles.Read(RepositoryFiles.Package + "/package.json"))
        .RootElement.GetProperty("version").GetString();

    [TestCase("Directory.Build.props", @"<Version>([^<]+)</Version>")]
    [TestCase("Web/package.json", @"""version"": ""([^""]+)""")]
    [TestCase("Web/package-lock.json", @"""version"": ""([^""]+)""")]
    [TestCase("CHANGELOG.md", @"(?m)^## \[([^\]]+)\]")]
    [TestCase(RepositoryFiles.Package + "/CHANGELOG.md", @"(?m)^## \[([^\]]+)\]")]
    public void Version_EveryPlace_IsThePackages(string path, string pattern)
    {
        var match = Regex.Match(RepositoryFiles.Read(path), pattern);

        Assert.That(match.Groups[1].Value, Is.EqualTo(Version));
    }
}
