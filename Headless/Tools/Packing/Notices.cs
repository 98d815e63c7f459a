using System.Text.RegularExpressions;

namespace Nowpose.Packing;

/// <summary>Names of the third-party packages that become part of what a user receives.</summary>
public static partial class Notices
{
    /// <summary>Gets the names whose row in THIRD-PARTY-NOTICES.md says that they ship.</summary>
    public static IEnumerable<string> ShippedIn(string notices) =>
        Row().Matches(notices).Where(row => row.Groups[2].Value.StartsWith("yes", StringComparison.Ordinal)).Select(row => row.Groups[1].Value);

    /// <summary>Gets the names at the head of each licence in the adapters' adapter-licences.txt.</summary>
    public static IEnumerable<string> BundledIn(string licences) => Heading().Matches(licences).Select(heading => heading.Groups[1].Value);

    [GeneratedRegex(@"(?m)^\| *(\S+) *\| *\d[^|]*\|[^|]*\|[^|]*\| *([^|]*?) *\|")]
    private static partial Regex Row();

    [GeneratedRegex(@"(?m)^((?:@[\w.-]+/)?[\w.-]+) \d+\.\d+\.\d+\S*, \S")]
    private static partial Regex Heading();
}
