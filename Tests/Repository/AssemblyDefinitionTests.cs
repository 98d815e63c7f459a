using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

public sealed class AssemblyDefinitionTests
{
    static readonly string[] TestRunners = { "UnityEngine.TestRunner", "UnityEditor.TestRunner" };

    static IEnumerable<string> Definitions => RepositoryFiles.Under(RepositoryFiles.Package, ".asmdef");

    static IEnumerable<string> Sources => RepositoryFiles.Under(RepositoryFiles.Package, ".cs");

    [TestCaseSource(nameof(Definitions))]
    public void Definition_Name_MatchesItsFile(string path)
    {
        Assert.That(Json(path).GetProperty("name").GetString(), Is.EqualTo(Path.GetFileNameWithoutExtension(path)));
    }

    [TestCaseSource(nameof(Definitions))]
    public void Definition_References_Resolve(string path)
    {
        var definition = Json(path);
        var ours = Definitions.Select(Path.GetFileNameWithoutExtension);

        var unresolved = Strings(definition, "references").Except(ours).Except(TestRunners);

        // An assembly for an optional package is compiled only if that package is installed.
        if (Strings(definition, "defineConstraints").Any(c => IsVersionDefine(definition, c))) return;
        Assert.That(unresolved.Where(name => !IsOptional(path, definition, name)), Is.Empty);
    }

    // Returns whether a referenced assembly exists only with its package. Unity ignores the reference without the package, and the
    // sources use the assembly only under a version define.
    static bool IsOptional(string path, JsonElement definition, string assembly)
    {
        if (assembly != "Unity.InputSystem") return false;
        var define = definition.GetProperty("versionDefines").EnumerateArray()
            .Single(v => v.GetProperty("name").GetString() == "com.unity.inputsystem").GetProperty("define").GetString();
        var folder = Path.GetDirectoryName(path).Replace('\\', '/') + "/";
        return Sources.Where(s => s.StartsWith(folder, StringComparison.Ordinal)).Select(RepositoryFiles.Read)
            .All(text => !CSharpCode.Of(Regex.Replace(text, $"#if {define}.*?#(else|endif)", "", RegexOptions.Singleline)).Contains("InputSystem"));
    }

    [TestCaseSource(nameof(Definitions))]
    public void Definition_WithPrecompiledReferences_OverridesReferences(string path)
    {
        var definition = Json(path);

        Assert.That(definition.GetProperty("overrideReferences").GetBoolean() || !Strings(definition, "precompiledReferences").Any());
    }

    [TestCaseSource(nameof(Sources))]
    public void Source_InThePackage_BelongsToAnAssembly(string path)
    {
        Assert.That(Definitions.Any(d => path.StartsWith(Path.GetDirectoryName(d).Replace('\\', '/') + "/", StringComparison.Ordinal)));
    }

    [Test]
    public void Core_Definition_HasNoEngineReferences()
    {
        Assert.That(Json(RepositoryFiles.Package + "/Runtime/Core/Nowpose.asmdef").GetProperty("noEngineReferences").GetBoolean());
    }

    [Test]
    public void Core_Sources_DoNotUseTheEngine()
    {
        var sources = RepositoryFiles.Under(RepositoryFiles.Package + "/Runtime/Core", ".cs").ToList();

        Assert.That(sources, Is.Not.Empty);
        Assert.That(sources.Where(s => Regex.IsMatch(CSharpCode.Of(RepositoryFiles.Read(s)), @"\bUnity(Engine|Editor)\b")), Is.Empty);
    }

    [Test]
    public void Tests_Definition_IsExcludedFromPlayers()
    {
        var tests = Json(RepositoryFiles.Package + "/Tests/Editor/Nowpose.Tests.asmdef");

        Assert.That(Strings(tests, "defineConstraints"), Does.Contain("UNITY_INCLUDE_TESTS"));
        Assert.That(Strings(tests, "includePlatforms"), Is.EqualTo(new[] { "Editor" }));
        Assert.That(tests.GetProperty("autoReferenced").GetBoolean(), Is.False);
    }

    static bool IsVersionDefine(JsonElement definition, string constraint)
    {
        return definition.GetProperty("versionDefines").EnumerateArray().Any(v => v.GetProperty("define").GetString() == constraint);
    }

    static IEnumerable<string> Strings(JsonElement definition, string name)
    {
        return definition.GetProperty(name).EnumerateArray().Select(r => r.GetString());
    }

    static JsonElement Json(string path) => JsonDocument.Parse(RepositoryFiles.Read(path)).RootElement;
}
