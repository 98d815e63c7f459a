using System.Text.RegularExpressions;

namespace Nowpose.Headless.Tests.Shaders;

/// <summary>Lists names that Unity's includes declare, with one list for each include that a shader uses.</summary>
static class UnityNames
{
    public const string List = "Tests/Shaders/unity-shader-names.txt";

    static readonly Regex Declarations = new(
        @"^\s*#define\s+(?<name>\w+)|^\s*(static\s+)?(float\w*|half\w*|int|uint)\s+(?<name>\w+)\s*(\[\w+\])?\s*[;(]"
        + @"|UNITY_DEFINE_INSTANCED_PROP\(\w+, (?<name>\w+)\)\s*$",
        RegexOptions.Multiline | RegexOptions.CultureInvariant);

    static readonly Regex Uses = new(
        @"\b(UNITY_\w+|unity_\w+|Unity[A-Z]\w+|CBUFFER_\w+|SAMPLE_\w+|TEXTURE2D\w*"
        + @"|Transform[A-Z]\w+To\w+|Compute\w+Pos|_WorldSpaceCameraPos|_ScreenParams)\b",
        RegexOptions.CultureInvariant);

    static readonly Regex Comments = new("//[^\n]*|/\\*.*?\\*/", RegexOptions.Singleline | RegexOptions.CultureInvariant);

    /// <summary>Names of each include. The key is the include's name without its folder.</summary>
    public static IReadOnlyDictionary<string, IReadOnlySet<string>> Read()
    {
        var lists = new Dictionary<string, IReadOnlySet<string>>();
        HashSet<string> names = null;
        foreach (var line in RepositoryFiles.Read(List).Split('\n').Where(l => l.Length > 0 && l[0] != '#'))
        {
            if (line[0] == '[') lists.Add(line.Trim('[', ']'), names = new HashSet<string>());
            else names.Add(line.Split(' ')[0]);
        }
        return lists;
    }

    /// <summary>Returns the names that a substitute declares, except the names that only the substitute uses, which begin with NOWPOSE_.</summary>
    public static IEnumerable<string> DeclaredBy(string text) => Declarations.Matches(Comments.Replace(text, ""))
        .Select(m => m.Groups["name"].Value).Where(n => !n.StartsWith("NOWPOSE_", StringComparison.Ordinal)).Distinct();

    /// <summary>Returns the names in a shader that look like Unity's. Excludes the name of the material's buffer, which the shader defines.</summary>
    public static IEnumerable<string> UsedBy(string text) =>
        Uses.Matches(Comments.Replace(text, "")).Select(m => m.Value).Where(n => n != "UnityPerMaterial").Distinct();
}
