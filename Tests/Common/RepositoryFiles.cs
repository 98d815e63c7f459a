using Nowpose.Metas;
using NUnit.Framework;

namespace Nowpose.Tests.Common;

/// <summary>Lists and reads the files of this repository, except the output of builds and tools.</summary>
static class RepositoryFiles
{
    public const string Package = "Packages/com.nowpose.mril";

    static readonly HashSet<string> NotOurs = new()
    {
        ".git", ".vs", ".idea", "bin", "obj", "node_modules", "dist", "artifacts", "TestResults", "BenchmarkDotNet.Artifacts",
        "Library", "Temp", "Logs", "UserSettings", "nowpose-demo",
    };

    public static string Root { get; } = ProjectRoot.Find(TestContext.CurrentContext.TestDirectory);

    /// <summary>Paths of all files relative to the root, with forward slashes, in ordinal order.</summary>
    public static IEnumerable<string> All { get; } = FilesIn(Root).Order(StringComparer.Ordinal).ToList();

    public static IEnumerable<string> Under(string folder, params string[] extensions)
    {
        return All.Where(f => f.StartsWith(folder + "/", StringComparison.Ordinal) && extensions.Contains(Path.GetExtension(f)));
    }

    public static string Read(string path) => File.ReadAllText(Path.Combine(Root, path));

    public static bool Exists(string path) => Path.Exists(Path.Combine(Root, path));

    static IEnumerable<string> FilesIn(string folder)
    {
        var files = Directory.GetFiles(folder).Where(f => !NotOurs.Contains(Path.GetFileName(f)))
            .Select(f => Path.GetRelativePath(Root, f).Replace('\\', '/'));
        var folders = Directory.GetDirectories(folder).Where(d => !NotOurs.Contains(Path.GetFileName(d)));
        return files.Concat(folders.SelectMany(FilesIn));
    }
}
