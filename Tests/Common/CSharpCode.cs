using System.Text.RegularExpressions;

namespace Nowpose.Tests.Common;

static partial class CSharpCode
{
    /// <summary>The source without comments and the contents of strings: what is left are the names it uses.</summary>
    public static string Of(string source) => CommentsAndStrings().Replace(source, " ");

    [GeneratedRegex(""""
        //[^\n]* | /\*.*?\*/ | """.*?""" | (@\$?|\$@)"(?:""|[^"])*" | \$?"(?:\\.|[^"\\\n])*" | '(?:\\.|[^'\\\n])+'
        """", RegexOptions.Singleline | RegexOptions.IgnorePatternWhitespace)]
    private static partial Regex CommentsAndStrings();
}
