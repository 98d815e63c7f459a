using Nowpose.Cli.Messages;
using Nowpose.Editor.Messages;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Cli.Unity.UnityManifests;

namespace Nowpose.Headless.Tests.Cli.Unity;

/// <summary>Tests entries of the manifest that conflict with those the package needs.</summary>
public class UnityConflictTests
{
    [Test]
    public async Task Unity_OlderDependency_AppliesTheConflictRule()
    {
        const string manifest = "{\n  \"dependencies\": {\n    \"org.nuget.mathnet.numerics\": \"4.15.0\"\n  }\n}\n";
        using var project = new UnityProjectFolder(manifest);

        var refused = await project.RunAsync();
        Assert.That(project.Manifest, Is.EqualTo(manifest));
        var conflict = ManifestMessages.OtherVersion(
            project.At("Packages/manifest.json") + ":3", "org.nuget.mathnet.numerics", "4.15.0", "5.0.0 or newer");
        AssertRefused(refused, conflict);

        var kept = await project.RunAsync("--on-conflict", "keep");
        Assert.That(kept.Errors, Does.Contain(UnityProjectMessages.EntryKept(conflict)));
        Assert.That(Dependencies(project)["org.nuget.mathnet.numerics"], Is.EqualTo("4.15.0"));

        var replaced = await project.RunAsync("--on-conflict", "replace");
        Assert.That(replaced.Output, Does.Contain("org.nuget.mathnet.numerics 5.0.0 in place of 4.15.0"));
        Assert.That(Dependencies(project)["org.nuget.mathnet.numerics"], Is.EqualTo("5.0.0"));
        Assert.That(project.Backups, Is.EqualTo(new[] { "manifest.json.backup", "manifest.json.backup-2" }));
        Assert.That(project.Read("Packages/manifest.json.backup"), Is.EqualTo(manifest));
    }

    [Test]
    public async Task Unity_NewerDependency_KeepsIt()
    {
        using var project = new UnityProjectFolder("""{ "dependencies": { "org.nuget.mathnet.numerics": "6.1.0" } }""");

        var run = await project.RunAsync();

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(Dependencies(project)["org.nuget.mathnet.numerics"], Is.EqualTo("6.1.0"));
    }

    [Test]
    public async Task Unity_RegistryWithAnotherUrl_NamesTheUrlOrReplacesIt()
    {
        using var project = new UnityProjectFolder(
            """{ "scopedRegistries": [{ "name": "x", "url": "https://unitynuget-registry.azurewebsites.net", "scopes": ["org.nuget"] }] }""");

        AssertRefused(
            await project.RunAsync(), "org.nuget.mathnet.numerics comes from the registry https://unitynuget-registry.azurewebsites.net");
        Assert.That((await project.RunAsync("--on-conflict", "replace")).ExitStatus, Is.EqualTo(0));
        Assert.That(project.Manifest, Does.Contain("https://unitynuget-registry.openupm.com").And.Not.Contain("azurewebsites"));
    }

    [TestCase("https://own.example", false, "refuse", "keep or replace")]
    [TestCase("https://own.example", true, "refuse", "keep")]
    [TestCase("https://own.example", true, "replace", "keep")]
    [TestCase(null, false, "replace", "keep")]
    public async Task Unity_ConflictingRegistry_SuggestsTheApplicableRules(string url, bool isShared, string rule, string applicable)
    {
        var registry = (url == null ? "" : $"\"url\": \"{url}\", ") + "\"scopes\": [\"org.nuget\"" + (isShared ? ", \"a\"]" : "]");
        using var project = new UnityProjectFolder($$"""{ "scopedRegistries": [{ "name": "x", {{registry}} }] }""");

        var refused = await project.RunAsync("--on-conflict", rule);

        AssertRefused(refused, "");
        Assert.That(refused.Errors, Does.Match(MessagePattern.Of(UnityProjectMessages.Conflicts(
            ManifestMessages.OtherRegistry(MessagePattern.Any, "org.nuget.mathnet.numerics", url, MessagePattern.Any, isShared), applicable))));
        Assert.That((await project.RunAsync("--on-conflict", "keep")).ExitStatus, Is.EqualTo(0));
    }

    [Test]
    public async Task Unity_OlderPackageInTheManifest_NamesBothVersions()
    {
        using var project = new UnityProjectFolder(
            """{ "dependencies": { "com.nowpose.mril": "https://git.example/nowpose.git?path=/Packages/com.nowpose.mril#v0.0.9" } }""");

        AssertRefused(await project.RunAsync(), "#v0.0.9; 0.2.0 or newer is needed");
    }
}
