using System.Text.RegularExpressions;

namespace Nowpose.Packing;

/// <summary>Gets the names of third-party packages that are part of the released files.</summary>
public static partial class Notices
{
    /// <summary>Gets the names of packages that are marked as shipped in a row of THIRD-PARTY-NOTICES.md.</summary>
    public static IEnumerable<string> ShippedIn(string notices) =>
        Row().Matches(notices).Where(row => row.Groups[2].Value.StartsWith("yes", StringComparison.Ordinal)).Select(row => row.Groups[1].Value);

    /// <summary>Gets the names in the headings of the adapters' adapter-licences.txt.</summary>
    public static IEnumerable<string> BundledIn(string licences) => Heading().Matches(licences).Select(heading => heading.Groups[1].Value);

    [GeneratedRegex(@"(?m)^\| *(\S+) *\| *\d[^|]*\|[^|]*\|[^|]*\| *([^|]*?) *\|")]
    private static partial Regex Row();

    [GeneratedRegex(@"(?m)^((?:@[\w.-]+/)?[\w.-]+) \d+\.\d+\.\d+\S*, \S")]
    private static partial Regex Heading();
}
