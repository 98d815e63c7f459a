using System.Text.Json;
using System.Text.RegularExpressions;
using Nowpose.Editor;
using Nowpose.Editor.Setup;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Manual;

/// <summary>Tests that the pages about HoloLens name the packages and capabilities that the code of this package requires.</summary>
public sealed partial class DeploymentPageTests
{
    static readonly string Page = RepositoryFiles.Read(RepositoryFiles.Package + "/Documentation~/deploy-hololens2.md")
        + RepositoryFiles.Read(RepositoryFiles.Package + "/Documentation~/hololens2-settings.md");

    static IEnumerable<TestCaseData> Ranges =>
        from path in RepositoryFiles.Under(RepositoryFiles.Package + "/Runtime", ".asmdef")
        let definition = JsonDocument.Parse(RepositoryFiles.Read(path)).RootElement
        let needed = definition.GetProperty("defineConstraints").EnumerateArray().Select(d => d.GetString()).ToHashSet()
        from define in definition.GetProperty("versionDefines").EnumerateArray()
        where needed.Contains(define.GetProperty("define").GetString())
        let package = define.GetProperty("name").GetString()
        let expression = define.GetProperty("expression").GetString()
        from version in VersionsOf(package)
        select new TestCaseData(Path.GetFileNameWithoutExtension(path), package, version, expression);

    [TestCaseSource(nameof(Ranges))]
    public void Version_NamedOnThePage_EnablesTheAssembly(string assembly, string package, string version, string expression)
    {
        Assert.That(Contains(expression, Version.Parse(version)), $"{assembly} requires {package} {expression}");
    }

    [Test]
    public void DevicePackages_OnThePage_HaveVersions()
    {
        var named = Ranges.Select(r => (string)r.Arguments[1]).Distinct();

        Assert.That(named, Is.SupersetOf(new[] { "com.microsoft.mixedreality.openxr", "com.unity.xr.arfoundation" }));
    }

    [Test]
    public void Capabilities_NamedOnThePage_MatchTheSetupWindow()
    {
        var looked = ProjectChecks.ForHoloLens().Select(c => c.Title)
            .Where(title => title.StartsWith("Capability ", StringComparison.Ordinal)).Select(title => title["Capability ".Length..]);
        var table = Page[Page.IndexOf("| Capability | Why |", StringComparison.Ordinal)..];

        var named = Rows().Matches(table[..table.IndexOf("\n\n", StringComparison.Ordinal)]).Select(row => row.Groups[1].Value).Skip(1);

        Assert.That(named, Is.EquivalentTo(looked));
    }

    [TestCase("1.9.0", "1.11.2", true)]
    [TestCase("1.9.0", "1.8.3", false)]
    [TestCase("[5.0.0,7.0.0-pre)", "5.1.5", true)]
    [TestCase("[5.0.0,7.0.0-pre)", "7.0.0", false)]
    [TestCase("[5.0.0,6.4.0-pre)", "6.3.5", true)]
    [TestCase("[5.0.0,7.0.0-pre)", "4.2.9", false)]
    public void Contains_VersionExpression_IsEvaluated(string expression, string version, bool contains)
    {
        Assert.That(Contains(expression, Version.Parse(version)), Is.EqualTo(contains));
    }

    static IEnumerable<string> VersionsOf(string package) =>
        Regex.Matches(Page, $@"`{Regex.Escape(package)}` (\d+\.\d+\.\d+)").Select(m => m.Groups[1].Value).Distinct();

    // Evaluates a version expression of Unity. A single version is the minimum. An upper bound that is a preview also excludes the release.
    static bool Contains(string expression, Version version)
    {
        var bounds = expression.Trim('[', ')').Split(',').Select(b => Version.Parse(b.Split('-')[0])).ToArray();
        return version >= bounds[0] && (bounds.Length == 1 || version < bounds[1]);
    }

    [GeneratedRegex(@"^\| (\w+) \|", RegexOptions.Multiline)]
    private static partial Regex Rows();
}
