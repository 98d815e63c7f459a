using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Manual;

/// <summary>Tests the block in the README that a user copies to Packages/manifest.json. With an error in it, Unity resolves no packages.</summary>
public sealed partial class ReadmeManifestTests
{
    const string ModulePrefix = "com.unity.modules.";

    static readonly JsonElement Block = Parse(Blocks().Match(RepositoryFiles.Read(RepositoryFiles.Package + "/README.md")).Groups[1].Value);
    static readonly JsonElement Package = Parse(RepositoryFiles.Read(RepositoryFiles.Package + "/package.json"));
    static readonly JsonElement Project = Parse(RepositoryFiles.Read("Packages/manifest.json"));

    [Test]
    public void ManifestBlock_Package_IsThisRepositoryAtItsVersion()
    {
        var url = Block.GetProperty("dependencies").GetProperty(Package.GetProperty("name").GetString()).GetString();

        Assert.That(url, Is.EqualTo(
            "https://github.com/OWNER/nowpose.git?path=/" + RepositoryFiles.Package + "#v" + Package.GetProperty("version").GetString()));
    }

    [Test]
    public void ManifestBlock_Dependencies_MatchThePackage()
    {
        var own = Package.GetProperty("name").GetString();

        var named = Dependencies(Block).Where(d => !d.StartsWith(own + " ", StringComparison.Ordinal));

        // Modules are excluded, because they are part of each Unity installation, and the package itself enables them.
        Assert.That(named, Is.EquivalentTo(Dependencies(Package).Where(d => !d.StartsWith(ModulePrefix, StringComparison.Ordinal))));
    }

    [Test]
    public void ManifestBlock_Registries_MatchTheProject()
    {
        Assert.That(Registries(Block), Is.EquivalentTo(Registries(Project)));
    }

    [Test]
    public void ManifestBlock_DependenciesFromOtherRegistries_HaveARegistry()
    {
        var scopes = Block.GetProperty("scopedRegistries").EnumerateArray()
            .SelectMany(r => r.GetProperty("scopes").EnumerateArray()).Select(s => s.GetString()).ToList();

        var foreign = Dependencies(Package).Where(d => !d.StartsWith("com.unity.", StringComparison.Ordinal));

        Assert.That(foreign.Where(d => !scopes.Any(s => d.StartsWith(s + ".", StringComparison.Ordinal))), Is.Empty);
    }

    static IEnumerable<string> Dependencies(JsonElement manifest) =>
        manifest.GetProperty("dependencies").EnumerateObject().Select(d => d.Name + " " + d.Value.GetString());

    static IEnumerable<string> Registries(JsonElement manifest) =>
        manifest.GetProperty("scopedRegistries").EnumerateArray().Select(r => Regex.Replace(r.GetRawText(), @"\s", ""));

    static JsonElement Parse(string json) => JsonDocument.Parse(json).RootElement;

    [GeneratedRegex(@"```json\r?\n(.*?)```", RegexOptions.Singleline)]
    private static partial Regex Blocks();
}
