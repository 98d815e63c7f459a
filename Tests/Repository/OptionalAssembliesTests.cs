using System.Text.Json;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>
/// Checks, for any set of optional packages, that each assembly that Unity compiles finds the assemblies that it references. The projects
/// in Headless check that each assembly compiles with exactly these references.
/// </summary>
public sealed partial class OptionalAssembliesTests
{
    /// <summary>Assemblies of each optional package that Nowpose's assemblies reference.</summary>
    static readonly Dictionary<string, string[]> Packages = new()
    {
        ["com.endel.nativewebsocket"] = ["colyseus.nativewebsocket"],
        ["com.unity.xr.core-utils"] = ["Unity.XR.CoreUtils"],
        ["com.unity.xr.arfoundation"] = ["Unity.XR.ARFoundation", "Unity.XR.ARSubsystems"],
        ["com.unity.xr.openxr"] = ["Unity.XR.OpenXR"],
        ["com.microsoft.mixedreality.openxr"] = ["Microsoft.MixedReality.OpenXR"],
        ["com.unity.xr.interaction.toolkit"] = ["Unity.XR.Interaction.Toolkit"],
        ["org.mixedrealitytoolkit.core"] = ["MixedReality.Toolkit.Core"],
        ["org.mixedrealitytoolkit.uxcore"] = ["MixedReality.Toolkit.UXCore"],
        ["org.mixedrealitytoolkit.spatialmanipulation"] = ["MixedReality.Toolkit.SpatialManipulation"],
    };

    /// <summary>Dependencies of the packages according to their package.json. Apart from these, each package is independent of the others.</summary>
    static readonly (string Package, string Dependency)[] Dependencies =
    [
        ("com.unity.xr.arfoundation", "com.unity.xr.core-utils"),
        ("com.microsoft.mixedreality.openxr", "com.unity.xr.openxr"),
        ("com.unity.xr.interaction.toolkit", "com.unity.xr.core-utils"),
    ];

    static readonly string[] EditorAssemblies = ["UnityEngine.TestRunner", "UnityEditor.TestRunner"];

    static readonly string[] PluginPlatforms = ["Android", "Editor", "WSA", "WindowsStandalone64"];

    static IReadOnlyList<Definition> Definitions { get; } = RepositoryFiles.Under(RepositoryFiles.Package, ".asmdef")
        .Where(p => !p.Contains("/Samples~/")).Select(p => new Definition(p)).ToList();

    static IEnumerable<string> OptionalNames => Definitions.Where(d => d.IsOptional).Select(d => d.Name);

    [Test]
    public void Assembly_AnySetOfOptionalPackages_ResolvesItsReferences()
    {
        var missing = new SortedSet<string>();
        foreach (var installed in Sets())
        {
            var ours = Definitions.Where(d => d.IsCompiledWith(installed)).ToList();
            var there = installed.SelectMany(p => Packages[p]).Concat(ours.Select(d => d.Name)).Concat(EditorAssemblies).ToHashSet();
            foreach (var definition in ours)
                foreach (var reference in definition.References.Where(r => !there.Contains(r) && !definition.MayDoWithout(r)))
                    missing.Add(definition.Name + " without " + reference + ", with " + string.Join(" ", installed.Order()));
        }

        Assert.That(missing, Is.Empty);
    }

    [TestCaseSource(nameof(OptionalNames))]
    public void OptionalAssembly_AnyPackageMissing_IsNotCompiled(string name)
    {
        var definition = Definitions.Single(d => d.Name == name);

        Assert.That(definition.IsCompiledWith(definition.Packages));
        foreach (var package in definition.Packages)
            Assert.That(definition.IsCompiledWith(definition.Packages.Where(p => p != package).ToHashSet()), Is.False, package);
    }

    // Otherwise the constraint would never be defined, and the assembly would not be compiled anywhere.
    [TestCaseSource(nameof(OptionalNames))]
    public void OptionalAssembly_EveryConstraint_IsAVersionDefine(string name)
    {
        var definition = Definitions.Single(d => d.Name == name);

        Assert.That(definition.Constraints, Is.SubsetOf(definition.VersionDefines.Select(v => v.Define)));
    }

    [Test]
    public void VersionDefines_OfOnePackage_AreConsistent()
    {
        var different = Definitions.SelectMany(d => d.VersionDefines).GroupBy(v => v.Define).Where(g => g.Distinct().Count() > 1);

        Assert.That(different.Select(g => g.Key), Is.Empty);
    }

    // The plugin's own assembly exists only on these platforms, even if its package is installed.
    [Test]
    public void Platforms_OfAssembliesThatUseMicrosoftsPlugin_MatchThePlugin()
    {
        var onIt = Definitions.Where(d => d.References.Contains("Microsoft.MixedReality.OpenXR")).ToList();

        Assert.That(onIt, Has.Count.EqualTo(2));
        Assert.That(onIt.Select(d => d.Platforms), Is.All.EqualTo(PluginPlatforms));
    }

    // Without code for single platforms, sources that compile here also compile in the Editor, on UWP and on all other platforms.
    [TestCase("ArFoundation")]
    [TestCase("OpenXR")]
    [TestCase("OpenXRAnchoring")]
    public void Sources_DeviceAssembly_AreEqualOnAllPlatforms(string folder)
    {
        var sources = RepositoryFiles.Under(RepositoryFiles.Package + "/Runtime/" + folder, ".cs").ToList();
        var versions = Definitions.SelectMany(d => d.VersionDefines).Select(v => v.Define).ToHashSet();

        var conditions = sources.SelectMany(s => Condition().Matches(RepositoryFiles.Read(s))).Select(m => m.Groups[1].Value.Trim());

        Assert.That(sources, Is.Not.Empty);
        Assert.That(conditions.Where(c => !versions.Contains(c)), Is.Empty);
    }

    [TestCase("Nowpose.ArFoundation")]
    [TestCase("Nowpose.OpenXR")]
    [TestCase("Nowpose.OpenXR.Anchoring")]
    public void Project_DeviceAssembly_ReferencesItsAssembliesAndTheEngine(string project)
    {
        var text = XDocument.Parse(RepositoryFiles.Read("Headless/Package/" + project + ".csproj"));
        var definition = Definitions.Single(d => d.Name == project);

        var seen = text.Descendants("ProjectReference").Select(r => Path.GetFileNameWithoutExtension((string)r.Attribute("Include")));

        Assert.That(seen, Is.EquivalentTo(definition.References.Append("UnityEngine")));
        Assert.That((string)text.Descendants("DisableTransitiveProjectReferences").Single(), Is.EqualTo("true"));
    }

    [GeneratedRegex(@"^\s*#\s*(?:if|elif)\b(.*)$", RegexOptions.Multiline)]
    private static partial Regex Condition();

    static IEnumerable<HashSet<string>> Sets()
    {
        var names = Packages.Keys.ToArray();
        for (var bits = 0; bits < 1 << names.Length; bits++)
        {
            var set = names.Where((_, i) => (bits & (1 << i)) != 0).ToHashSet();
            if (Dependencies.All(d => !set.Contains(d.Package) || set.Contains(d.Dependency))) yield return set;
        }
    }

    sealed class Definition
    {
        readonly string _path;

        public Definition(string path)
        {
            _path = path;
            var json = JsonDocument.Parse(RepositoryFiles.Read(path)).RootElement;
            Name = json.GetProperty("name").GetString();
            References = Strings(json, "references");
            Platforms = Strings(json, "includePlatforms");
            Constraints = Strings(json, "defineConstraints");
            VersionDefines = json.GetProperty("versionDefines").EnumerateArray()
                .Select(v => (v.GetProperty("define").GetString(), v.GetProperty("name").GetString(), v.GetProperty("expression").GetString())).ToArray();
        }

        public string Name { get; }
        public string[] References { get; }
        public string[] Platforms { get; }
        public string[] Constraints { get; }
        public (string Define, string Package, string Expression)[] VersionDefines { get; }

        /// <summary>The packages that are required to compile the assembly.</summary>
        public HashSet<string> Packages => VersionDefines.Where(v => Constraints.Contains(v.Define)).Select(v => v.Package).ToHashSet();

        public bool IsOptional => Packages.Count > 0;

        public bool IsCompiledWith(HashSet<string> installed) => Packages.IsSubsetOf(installed);

        /// <summary>
        /// Returns whether this assembly uses another optional assembly of the package only between #if and #endif, under defines that both
        /// assemblies have.
        /// </summary>
        public bool MayDoWithout(string reference)
        {
            var other = Definitions.SingleOrDefault(d => d.Name == reference);
            if (other == null || !other.IsOptional) return false;

            var defines = other.Constraints.Where(c => VersionDefines.Any(v => v.Define == c)).ToList();
            var folder = _path[.._path.LastIndexOf('/')];
            return defines.Count == other.Constraints.Length
                && RepositoryFiles.Under(folder, ".cs").Any(f => defines.All(d => RepositoryFiles.Read(f).Contains("#if " + d)));
        }

        static string[] Strings(JsonElement json, string name) => json.GetProperty(name).EnumerateArray().Select(e => e.GetString()).ToArray();
    }
}
