using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>Checks that no file of the repository depends on the machine on which it was written.</summary>
public sealed partial class MachineTraceTests
{
    static readonly string[] Registries =
    {
        "registry.npmjs.org", "api.nuget.org", "unitynuget-registry.openupm.com", "package.openupm.com", "packages.unity.com",
    };

    static readonly string[] Binaries = { ".png", ".gz", ".pfx", ".gif", ".dll" };

    [Test]
    public void Files_All_ContainNoMachinePath()
    {
        var texts = RepositoryFiles.All.Where(f => !Binaries.Contains(Path.GetExtension(f)));

        var found = texts.SelectMany(f => MachinePaths().Matches(RepositoryFiles.Read(f)).Select(m => f + ": " + m.Value));

        Assert.That(found, Is.Empty);
    }

    [TestCase("see ~home~someone/x", true)]
    [TestCase("\"~root~.nuget\"", true)]
    [TestCase("c:~Users~x", true)]
    [TestCase("path=~work~main", true)]
    [TestCase("https://example.org~home~page", false)]
    [TestCase("a~work~b", false)]
    [TestCase("~usr~bin/env", false)]
    public void MachinePath_Sample_IsRecognised(string text, bool isMachinePath)
    {
        Assert.That(MachinePaths().IsMatch(text.Replace('~', '/')), Is.EqualTo(isMachinePath));
    }

    [Test]
    public void Configuration_Registries_ArePublic()
    {
        var files = RepositoryFiles.All.Where(f => Path.GetFileName(f).ToLowerInvariant() is ".npmrc" or "nuget.config" or "manifest.json");

        var hosts = files.SelectMany(f => Hosts().Matches(RepositoryFiles.Read(f)).Select(m => m.Groups[1].Value));

        Assert.That(hosts, Is.SubsetOf(Registries));
    }

    [Test]
    public void LockFiles_Packages_HaveNoAddress()
    {
        var locks = RepositoryFiles.All.Where(f => Path.GetFileName(f).EndsWith("-lock.json", StringComparison.Ordinal)).ToList();

        Assert.That(locks, Does.Contain("Web/package-lock.json"));
        Assert.That(locks.Where(f => RepositoryFiles.Read(f).Contains("\"resolved\"", StringComparison.Ordinal)), Is.Empty);
    }

    [GeneratedRegex(@"(?<![\w./-])(/(home|root|work|Users|mnt)/[\w.-]+|[A-Za-z]:[/\\]+Users[/\\])", RegexOptions.CultureInvariant)]
    private static partial Regex MachinePaths();

    [GeneratedRegex(@"https?://([^/""'\s]+)")]
    private static partial Regex Hosts();
}
