using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>Checks that all tests that the table of threats names exist.</summary>
public sealed partial class SecurityDocumentTests
{
    const string Page = "SECURITY.md";

    [GeneratedRegex(@"`([A-Z]\w*_\w+)`")]
    private static partial Regex TestName();

    [GeneratedRegex(@"public (?:async )?(?:void|Task) ([A-Z]\w*_\w+)\(")]
    private static partial Regex TestMethod();

    // Matches the names of the adapters' tests, which are JavaScript.
    [GeneratedRegex(@"(?m)^\s*it\('([A-Z]\w*_\w+)'")]
    private static partial Regex AdapterTest();

    static IEnumerable<string> Rows => RepositoryFiles.Read(Page).Split('\n')
        .SkipWhile(line => !line.StartsWith("| threat")).Skip(2).TakeWhile(line => line.StartsWith('|'));

    [Test]
    public void Threats_EachRow_NamesExistingTests()
    {
        var known = RepositoryFiles.Under("Tests", ".cs").Concat(RepositoryFiles.Under(RepositoryFiles.Package + "/Tests", ".cs"))
            .SelectMany(file => TestMethod().Matches(RepositoryFiles.Read(file))).Select(match => match.Groups[1].Value)
            .Concat(RepositoryFiles.Under("Gateway/Adapters/test", ".mjs")
                .SelectMany(file => AdapterTest().Matches(RepositoryFiles.Read(file))).Select(match => match.Groups[1].Value)).ToHashSet();

        Assert.That(Rows, Is.Not.Empty);
        foreach (var row in Rows)
        {
            var named = TestName().Matches(row.Split('|')[^2]).Select(match => match.Groups[1].Value).ToArray();
            Assert.That(named, Is.Not.Empty, row);
            Assert.That(named.Where(name => !known.Contains(name)), Is.Empty, "the listed tests do not exist");
        }
    }

    [TestCase("spoofed sync")]
    [TestCase("replay")]
    [TestCase("delay in one direction")]
    [TestCase("step of")]
    [TestCase("ramp of")]
    [TestCase("future")]
    [TestCase("past")]
    [TestCase("duplicates")]
    [TestCase("nan")]
    [TestCase("oversized")]
    [TestCase("fragments")]
    [TestCase("compressed")]
    [TestCase("deep json")]
    [TestCase("slowloris")]
    [TestCase("half-open")]
    [TestCase("impersonation")]
    [TestCase("OPC UA")]
    [TestCase("ADS")]
    [TestCase("broker")]
    public void Threats_EachRequiredThreat_HasARow(string words) =>
        Assert.That(Rows.Any(row => row.Split('|')[1].Contains(words, StringComparison.OrdinalIgnoreCase)), Is.True);
}
