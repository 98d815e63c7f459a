using System.Text.RegularExpressions;

namespace Nowpose.Unity.Tests.Engine.Api;

/// <summary>Reads a list of Unity's API, in which the lines of the members follow the line of their type.</summary>
static partial class ListedApi
{
    internal static IEnumerable<(string Type, string Line)> Read(string path)
    {
        var type = "";
        foreach (var line in File.ReadLines(path).Where(l => l.Length > 0 && !l.StartsWith('#')))
        {
            var ordered = SwappedUsage().Replace(line, "$2, $1");
            if (line.StartsWith("type ", StringComparison.Ordinal)) type = ordered;
            yield return (type, ordered);
        }
    }

    [GeneratedRegex(@"(AllowMultiple = \w+), (Inherited = \w+)")]
    private static partial Regex SwappedUsage();
}
