using System.Text.RegularExpressions;

namespace Nowpose.Tests.Common;

static partial class CSharpCode
{
    /// <summary>Returns the source without comments and without the contents of strings. Only the names that it uses remain.</summary>
    public static string Of(string source) => CommentsAndStrings().Replace(source, " ");

    [GeneratedRegex(""""
        //[^\n]* | /\*.*?\*/ | """.*?""" | (@\$?|\$@)"(?:""|[^"])*" | \$?"(?:\\.|[^"\\\n])*" | '(?:\\.|[^'\\\n])+'
        """", RegexOptions.Singleline | RegexOptions.IgnorePatternWhitespace)]
    private static partial Regex CommentsAndStrings();
}
