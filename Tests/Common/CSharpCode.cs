using System.Text.RegularExpressions;

namespace Nowpose.Tests.Common;

static partial class CSharpCode
{
    /// <summary>Returns the source without comments and strings. A name in the result is therefore a name that the code uses.</summary>
    public static string Of(string source) => CommentsAndStrings().Replace(source, " ");

    [GeneratedRegex(""""
        //[^\n]* | /\*.*?\*/ | """.*?""" | (@\$?|\$@)"(?:""|[^"])*" | \$?"(?:\\.|[^"\\\n])*" | '(?:\\.|[^'\\\n])+'
        """", RegexOptions.Singleline | RegexOptions.IgnorePatternWhitespace)]
    private static partial Regex CommentsAndStrings();
}
