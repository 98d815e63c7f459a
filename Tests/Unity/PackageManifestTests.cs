using System.Text.Json;
using NUnit.Framework;

namespace Nowpose.Unity.Tests;

public sealed class PackageManifestTests
{
    const string ModulePrefix = "com.unity.modules.";

    static readonly JsonElement Manifest = Json(RepositoryFiles.Package + "/package.json");
    static readonly JsonElement Project = Json("Packages/manifest.json");

    [TestCase("name", "com.nowpose.mril")]
    [TestCase("displayName", "Nowpose")]
    [TestCase("version", "0.2.0")]
    [TestCase("unity", "2021.3")]
    [TestCase("license", "MIT")]
    public void PackageManifest_Field_HasThePublishedValue(string field, string value)
    {
        Assert.That(Manifest.GetProperty(field).GetString(), Is.EqualTo(value));
    }

    /// <summary>While a package has no such address, the links of the Package Manager open the files of the installed package.</summary>
    [TestCase("documentationUrl", "/Documentation~/index.md")]
    [TestCase("changelogUrl", "/CHANGELOG.md")]
    [TestCase("licensesUrl", "/LICENSE.md")]
    public void PackageManifest_Links_OpenTheFilesOfThePackage(string field, string file)
    {
        Assert.That(Manifest.TryGetProperty(field, out _), Is.False);
        Assert.That(RepositoryFiles.Exists(RepositoryFiles.Package + file));
    }

    [Test]
    public void PackageManifest_Dependencies_MatchTheExpectedList()
    {
        var others = Dependencies(Manifest).Where(d => !d.Key.StartsWith(ModulePrefix, StringComparison.Ordinal));

        Assert.That(others.Select(d => d.Key + " " + d.Value), Is.EquivalentTo(new[]
        {
            "com.unity.nuget.newtonsoft-json 3.2.1",
            "org.nuget.mathnet.numerics 5.0.0",
        }));
    }

    [Test]
    public void PackageManifest_ModuleDependencies_AreTheModulesInUse()
    {
        var declared = Dependencies(Manifest).Where(d => d.Key.StartsWith(ModulePrefix, StringComparison.Ordinal));
        // The sample for MRTK3 is excluded: XR Interaction Toolkit, which it requires, depends on the modules for colliders and canvases.
        var used = UnityModules.UsedUnder(RepositoryFiles.Package, RepositoryFiles.Package + "/Samples~/HoloLens 2 (MRTK3)")
            .Select(m => ModulePrefix + m + " 1.0.0");

        Assert.That(declared.Select(d => d.Key + " " + d.Value), Is.EquivalentTo(used));
    }

    [Test]
    public void PackageManifest_Samples_Exist()
    {
        var samples = Manifest.GetProperty("samples");

        Assert.That(samples.GetArrayLength(), Is.Positive);
        foreach (var sample in samples.EnumerateArray())
            Assert.That(RepositoryFiles.Exists(RepositoryFiles.Package + "/" + sample.GetProperty("path").GetString()), sample.ToString());
    }

    [Test]
    public void ProjectManifest_Dependencies_IncludeThePackagesDependencies()
    {
        var project = Dependencies(Project);

        foreach (var (name, version) in Dependencies(Manifest))
            Assert.That(project.GetValueOrDefault(name, version), Is.EqualTo(version), name);
        Assert.That(project.Keys, Does.Contain("com.unity.test-framework"));
    }

    [Test]
    public void ProjectManifest_ModulesUsedByAssets_AreIncluded()
    {
        var available = Dependencies(Project).Keys.Concat(Dependencies(Manifest).Keys);

        Assert.That(UnityModules.UsedUnder("Assets").Select(m => ModulePrefix + m), Is.SubsetOf(available));
    }

    [Test]
    public void ProjectManifest_Testables_ContainThePackage()
    {
        Assert.That(Project.GetProperty("testables").EnumerateArray().Select(t => t.GetString()), Does.Contain("com.nowpose.mril"));
    }

    static Dictionary<string, string> Dependencies(JsonElement manifest)
    {
        return manifest.GetProperty("dependencies").EnumerateObject().ToDictionary(d => d.Name, d => d.Value.GetString());
    }

    static JsonElement Json(string path) => JsonDocument.Parse(RepositoryFiles.Read(path)).RootElement;
}
