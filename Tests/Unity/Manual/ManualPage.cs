using System.Text.RegularExpressions;

namespace Nowpose.Unity.Tests.Manual;

/// <summary>Reads a page of the package's manual.</summary>
sealed partial class ManualPage
{
    public const string Folder = RepositoryFiles.Package + "/Documentation~";

    readonly string _text;

    ManualPage(string text) => _text = text;

    public static IEnumerable<string> Names => RepositoryFiles.Under(Folder, ".md").Select(p => Path.GetFileName(p));

    public static ManualPage Read(string name) => new(RepositoryFiles.Read(Folder + "/" + name));

    public static bool Exists(string name) => RepositoryFiles.Exists(Folder + "/" + name);

    public string Title => _text.Split('\n')[0].TrimStart('#', ' ');

    /// <summary>Names of the pages to which this page has links.</summary>
    public IReadOnlyList<string> Linked => Links().Matches(_text).Select(m => m.Groups[1].Value).Distinct().ToList();

    /// <summary>
    /// Returns the rows of the first table below a heading, with trimmed cells and without the header row; empty if no table exists.
    /// </summary>
    public IReadOnlyList<string[]> TableUnder(string heading)
    {
        var lines = _text.Split('\n').SkipWhile(l => l.Trim() != "## " + heading).Skip(1)
            .TakeWhile(l => !l.StartsWith("## ", StringComparison.Ordinal));
        return lines.SkipWhile(l => !l.StartsWith('|')).TakeWhile(l => l.StartsWith('|')).Skip(2)
            .Select(l => l.Trim().Trim('|').Split('|').Select(c => c.Trim()).ToArray())
            .ToList();
    }

    [GeneratedRegex(@"\]\(([\w-]+\.md)(?:#[^)]*)?\)")]
    private static partial Regex Links();
}
