using System.Text;
using System.Text.RegularExpressions;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>Finds the string literals of a C# source file. Concatenated literals count as one string; each interpolated value is 0.</summary>
/// <remarks>Skips comments and attributes. A string within an interpolated value or an argument is a separate text.</remarks>
sealed partial class SourceTexts
{
    readonly string _source;
    readonly List<SourceText> _found = [];
    int _at;

    SourceTexts(string source) => _source = source;

    public static IReadOnlyList<SourceText> In(string source)
    {
        var texts = new SourceTexts(source);
        texts.Read("", '\0', null, "");
        return texts._found;
    }

    /// <summary>Counts the words of a string. A name with an underscore, a path or a unit of one letter is not a word.</summary>
    public static int WordsIn(string text) =>
        text.Split((char[])null, StringSplitOptions.RemoveEmptyEntries).Count(part => Word().IsMatch(part));

    /// <summary>Reads up to the end of a pair of brackets.</summary>
    /// <param name="call">The name before the opening bracket.</param>
    /// <param name="end">The closing bracket; '\0' for the end of the file.</param>
    /// <param name="assigned">Name of the member to which the content of the brackets is assigned; null if it is not assigned.</param>
    /// <param name="receiver">The call whose argument is or includes the content of the brackets.</param>
    void Read(string call, char end, string assigned, string receiver)
    {
        // The names before the current position, such as "new Command" or "Description".
        var before = "";
        StringBuilder text = null;
        var last = '\0';
        while (_at < _source.Length)
        {
            if (Skip()) continue;
            if (Start().Match(_source, _at) is { Success: true } start)
            {
                text ??= new StringBuilder(last == '+' ? "0" : "");
                _at += start.Length;
                ReadString(text, start.Value, receiver);
                last = '"';
                continue;
            }
            if (Name().Match(_source, _at) is { Success: true } name)
            {
                _at += name.Length;
                if (last != '"') before = last == '.' ? before + "." + name.Value : name.Value;
                if (text != null && last == '+') text.Append('0');
                last = 'a';
                continue;
            }
            var c = _source[_at++];
            if (c == end)
            {
                End();
                return;
            }
            if (c is '(' or '[' or '{')
            {
                var isAttribute = c == '[' && last is '\0' or ';' or '{' or '}' or ']' && Attribute().IsMatch(_source.AsSpan(_at));
                var closing = c == '(' ? ')' : c == '[' ? ']' : '}';
                if (c == '{') End();
                var count = _found.Count;
                // Round brackets after an operator or keyword group values; their content belongs to the argument around them.
                var isCall = c == '(' && last == 'a' && !Keyword().IsMatch(before);
                Read(c == '(' ? before : "", closing, assigned, isCall ? before : c == '{' ? "" : receiver);
                if (isAttribute) _found.RemoveRange(count, _found.Count - count);
                if (c == '{') End();
                c = closing;
            }
            else if (c == '=' && _source[_at] is not ('=' or '>') && last == 'a') assigned = before;
            else if (c is ',' or ';' or '?' or ':' or '=' or '&' or '|' or '<' or '>') End();
            if (c is ',' or ';') assigned = null;
            last = c;
        }
        End();

        void End()
        {
            if (text != null) _found.Add(new SourceText(text.ToString(), call, assigned, receiver));
            text = null;
        }
    }

    // Skips comments, directives, white space and character literals.
    bool Skip()
    {
        var skipped = Blank().Match(_source, _at);
        _at += skipped.Length;
        return skipped.Success;
    }

    void ReadString(StringBuilder text, string start, string receiver)
    {
        var quotes = start.Count(c => c == '"');
        var dollars = start.Count(c => c == '$');
        var isRaw = quotes >= 3;
        var isVerbatim = start.Contains('@');
        var end = isRaw ? new string('"', quotes) : "\"";
        while (_at < _source.Length)
        {
            if (isVerbatim && Has("\"\"")) Take(text, 2);
            else if (Has(end))
            {
                _at += end.Length;
                return;
            }
            else if (!isRaw && !isVerbatim && Has("\\")) Take(text, 2);
            else if (dollars > 0 && !isRaw && (Has("{{") || Has("}}"))) Take(text, 2);
            else if (dollars > 0 && Has(new string('{', isRaw ? dollars : 1)))
            {
                _at += isRaw ? dollars : 1;
                text.Append('0');
                Read("", '}', null, receiver);
                if (isRaw) _at += dollars - 1;
            }
            else Take(text, 1);
        }
    }

    void Take(StringBuilder text, int length)
    {
        // Replaces an escaped line break or tab with a space, because it separates words.
        text.Append(_source[_at] == '\\' ? _source[_at + 1] is 'n' or 'r' or 't' ? ' ' : _source[_at + 1] : _source[_at]);
        _at += length;
    }

    bool Has(string text) => string.CompareOrdinal(_source, _at, text, 0, text.Length) == 0;

    [GeneratedRegex(@"\G(?:[$@]*""{3,}|\$*@?\$*"")")]
    private static partial Regex Start();

    [GeneratedRegex(@"\G[@\w]+")]
    private static partial Regex Name();

    [GeneratedRegex(@"\G(?:\s+|//[^\n]*|/\*.*?\*/|(?<=\n[ \t]*)#[^\n]*|'(?:\\.[^']*|[^'\\])')", RegexOptions.Singleline)]
    private static partial Regex Blank();

    [GeneratedRegex("^(?:return|throw|when|if|await|in|is|and|or|not|else|yield|switch|case)$")]
    private static partial Regex Keyword();

    [GeneratedRegex(@"\A\s*(?:\w+:\s*)?[A-Z]\w*(?:\.\w+)*\s*[\](,]")]
    private static partial Regex Attribute();

    [GeneratedRegex(@"^[([{""“‘'<]*(?:\p{L}[\p{L}’'-]*\p{L}|[aAI])[)\]}""”’'>.,:;?!…]*$")]
    private static partial Regex Word();
}

/// <param name="Call">Name of the method or type whose arguments contain the text, such as Command; empty if there is none.</param>
/// <param name="Assigned">Name of the member to which the text is assigned; null if it is not assigned.</param>
/// <param name="Receiver">
/// The innermost call that receives the text, also as a part of an interpolated string or of a conditional value; empty if there is none.
/// </param>
sealed record SourceText(string Text, string Call, string Assigned, string Receiver);
