using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>
/// Checks that each namespace is the assembly's root namespace plus the folder path below it, that each folder holds at least three files, and that
/// no source file is long.
/// </summary>
public sealed partial class FolderTests
{
    const int MinFiles = 3;
    const int MaxLines = 300;

    /// <summary>The stand-ins have the namespaces of the packages that they replace.</summary>
    const string StandIn = "Headless/StandIn/";

    /// <summary>A folder that all test projects compile.</summary>
    const string Common = "Tests/Common";

    /// <summary>
    /// Folders that may have fewer than three files: those that GitHub, Unity, MSBuild or the include of a shader requires, the small catalogue of
    /// the pages' messages, and two folders whose files fit into no other folder.
    /// </summary>
    static readonly string[] Small =
    [
        ".config", ".github", "Assets", "Cli/Properties", "Gateway/Adapters/licences", "Gateway/Properties",
        RepositoryFiles.Package + "/Runtime/Settings", "ProjectSettings", "Tests/Shaders/StandIns", "Web/Messages",
    ];

    /// <summary>The usual name of an editor assembly, which hides UnityEditor.Editor only inside that assembly.</summary>
    const string EditorAssembly = "Editor";

    static readonly Dictionary<string, string> Roots = RepositoryFiles.All
        .Where(file => file.EndsWith(".asmdef", StringComparison.Ordinal)
            || (file.EndsWith(".csproj", StringComparison.Ordinal) && !file.StartsWith("Headless/Package/", StringComparison.Ordinal)))
        .GroupBy(FolderOf).ToDictionary(group => group.Key, group => RootNamespaceOf(group.First()));

    static IEnumerable<string> Sources => RepositoryFiles.All.Where(file => file.EndsWith(".cs", StringComparison.Ordinal));

    [Test]
    public void Namespace_OfEachFile_MatchesItsFolder()
    {
        var wrong = from file in Sources
                    where !file.StartsWith(StandIn, StringComparison.Ordinal)
                    let declared = Declared().Match(RepositoryFiles.Read(file)).Groups[1].Value
                    where declared.Length > 0 && declared != ExpectedIn(FolderOf(file))
                    select $"{file}: {declared}, expected {ExpectedIn(FolderOf(file))}";

        Assert.That(wrong, Is.Empty);
    }

    [Test]
    public void Namespace_OfEachFile_HidesNoUnityType()
    {
        var types = Directory.GetFiles(Path.Combine(RepositoryFiles.Root, "Tests/Unity/Engine/Api"), "*.txt").SelectMany(File.ReadLines)
            .Select(line => EngineType().Match(line)).Where(match => match.Success).Select(match => match.Groups[1].Value).ToHashSet();
        Assert.That(types, Does.Contain("Time"), "the lists are not empty");
        var names = RepositoryFiles.Under(RepositoryFiles.Package, ".cs")
            .SelectMany(file => Declared().Match(RepositoryFiles.Read(file)).Groups[1].Value.Split('.')).ToHashSet();

        Assert.That(names.Intersect(types).Except([EditorAssembly]), Is.Empty);
    }

    [Test]
    public void Folder_WithFiles_HasAtLeastThreeFiles()
    {
        var files = RepositoryFiles.All.Where(file => !file.EndsWith(".meta", StringComparison.Ordinal)).ToList();
        var small = files.SelectMany(FoldersOf).Distinct()
            .Where(folder => !Roots.ContainsKey(folder) && !Small.Any(name => IsBelow(folder + "/", name)))
            .Where(folder => files.Count(file => IsBelow(file, folder)) < MinFiles);

        Assert.That(small, Is.Empty, "move their files to a folder with the same subject");
    }

    [Test]
    public void SourceFile_Each_HasAtMost300Lines()
    {
        var tooLong = RepositoryFiles.All.Where(file => Path.GetExtension(file) is ".cs" or ".ts" or ".mjs" or ".css" or ".html" or ".shader" or ".hlsl")
            .Where(file => File.ReadLines(Path.Combine(RepositoryFiles.Root, file)).Count() > MaxLines);

        Assert.That(tooLong, Is.Empty, "split them by subject");
    }

    static IEnumerable<string> FoldersOf(string path)
    {
        for (var folder = FolderOf(path); folder.Length > 0; folder = FolderOf(folder)) yield return folder;
    }

    static string ExpectedIn(string folder)
    {
        if (folder == Common) return "Nowpose.Tests.Common";
        var root = folder;
        while (!Roots.ContainsKey(root)) root = FolderOf(root);
        return Roots[root] + folder[root.Length..].Replace('/', '.');
    }

    static string RootNamespaceOf(string file)
    {
        var text = RepositoryFiles.Read(file);
        if (file.EndsWith(".csproj", StringComparison.Ordinal)) return RootNamespace().Match(text).Groups[1].Value;
        using var definition = JsonDocument.Parse(text);
        return definition.RootElement.GetProperty("rootNamespace").GetString();
    }

    static bool IsBelow(string file, string folder) => file.StartsWith(folder + "/", StringComparison.Ordinal);

    static string FolderOf(string path) => path.LastIndexOf('/') is var end and >= 0 ? path[..end] : "";

    [GeneratedRegex(@"^namespace ([\w.]+)", RegexOptions.Multiline)]
    private static partial Regex Declared();

    [GeneratedRegex("<RootNamespace>(.*?)<")]
    private static partial Regex RootNamespace();

    [GeneratedRegex(@"^type (?:\w+ )+(?:\w+\.)*(\w+)")]
    private static partial Regex EngineType();
}
