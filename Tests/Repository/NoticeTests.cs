using System.Text.Json;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

public sealed class NoticeTests
{
    static readonly Dictionary<string, string[]> Rows = Regex
        .Matches(RepositoryFiles.Read("THIRD-PARTY-NOTICES.md"), @"(?m)^\| *([^|]+?) *\| *(\d[^|]*?) *\| *([^|]*?) *\| *([^|]*?) *\| *([^|]*?) *\|")
        .ToDictionary(m => m.Groups[1].Value, m => m.Groups.Values.Skip(2).Select(g => g.Value).ToArray());

    [Test]
    public void Notices_EveryDependency_IsListedAtItsVersion()
    {
        var listed = Rows.Select(r => r.Key + " " + r.Value[0]);

        Assert.That(listed, Is.EquivalentTo(NuGetPackages().Concat(NpmPackages()).Concat(UnityPackages())));
    }

    [Test]
    public void Notices_EveryRow_HasNoEmptyField()
    {
        Assert.That(Rows.Where(r => r.Value.Any(string.IsNullOrEmpty)).Select(r => r.Key), Is.Empty);
    }

    static IEnumerable<string> NuGetPackages()
    {
        return XDocument.Parse(RepositoryFiles.Read("Directory.Packages.props")).Descendants("PackageVersion")
            .Select(p => p.Attribute("Include").Value + " " + p.Attribute("Version").Value);
    }

    static IEnumerable<string> NpmPackages() => new[] { "Web/package.json", "Vision/package.json", "Gateway/Adapters/package.json", ".ci/lint/package.json", ".ci/node/package.json" }
        .SelectMany(manifest => Dependencies(manifest, "dependencies", "devDependencies", "optionalDependencies")).Distinct();

    static IEnumerable<string> UnityPackages()
    {
        return Dependencies(RepositoryFiles.Package + "/package.json", "dependencies")
            .Where(d => !d.StartsWith("com.unity.modules.", StringComparison.Ordinal));
    }

    static IEnumerable<string> Dependencies(string path, params string[] sections)
    {
        var manifest = JsonDocument.Parse(RepositoryFiles.Read(path)).RootElement;
        return sections.Where(s => manifest.TryGetProperty(s, out _))
            .SelectMany(s => manifest.GetProperty(s).EnumerateObject())
            .Select(d => d.Name + " " + d.Value.GetString());
    }
}
