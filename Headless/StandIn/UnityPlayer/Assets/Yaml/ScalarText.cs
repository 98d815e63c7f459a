using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;

namespace Nowpose.UnityPlayer.Assets.Yaml;

/// <summary>
/// Writes one scalar as Unity does. A string with line breaks or non-ASCII characters is written in double quotes with escapes, because Unity decodes
/// escapes only there. Any other string is written without quotes if it can be read back unchanged, otherwise in single quotes. A long string is
/// wrapped at the first space after column 80.
/// </summary>
static class ScalarText
{
    const int BestWidth = 80;

    static readonly Regex Plain = new Regex(@"^(?:[A-Za-z0-9_./\\$^+;()-])(?:[ -~]*[!-~])?\z", RegexOptions.CultureInvariant);
    static readonly Regex NotPlain = new Regex(@"^-(?: |\z)|^---|[{}\[\],#&*|>'""%@`]|: |:\z|\t", RegexOptions.CultureInvariant);
    static readonly Regex Printable = new Regex(@"^[ -~]*\z", RegexOptions.CultureInvariant);

    /// <summary>
    /// Matches the compiler's name of the field of an automatic property. Unity writes this name without quotes, although it contains angle brackets.
    /// </summary>
    static readonly Regex BackingField = new Regex(@"^<\w+>k__BackingField[\w.\[\]]*\z", RegexOptions.CultureInvariant);

    /// <summary>Appends a scalar to the text of a file.</summary>
    /// <param name="text">Text of the file up to the scalar.</param>
    /// <param name="scalar">The scalar. This method chooses the style.</param>
    /// <param name="continuation">Indent of continuation lines.</param>
    public static void Append(StringBuilder text, YamlScalarNode scalar, int continuation)
    {
        var value = scalar.Value ?? "";
        if (value.Length == 0) return;
        if (!Printable.IsMatch(value)) AppendDoubleQuoted(text, value, continuation);
        else if (BackingField.IsMatch(value)) text.Append(value);
        else if (Plain.IsMatch(value) && !NotPlain.IsMatch(value)) AppendFolded(text, value, continuation);
        else AppendFolded(text.Append('\''), value.Replace("'", "''"), continuation).Append('\'');
    }

    static StringBuilder AppendFolded(StringBuilder text, string value, int continuation)
    {
        for (var i = 0; i < value.Length; i++)
        {
            if (value[i] == ' ' && IsAlone(value, i) && ColumnOf(text) > BestWidth) NewLine(text, continuation);
            else text.Append(value[i]);
        }
        return text;
    }

    static void AppendDoubleQuoted(StringBuilder text, string value, int continuation)
    {
        text.Append('"');
        for (var i = 0; i < value.Length; i++)
        {
            var letter = value[i];
            if (letter != ' ')
            {
                AppendLetter(text, letter);
                continue;
            }
            var breaks = i > 0 && value[i - 1] != ' ' && i < value.Length - 1 && ColumnOf(text) > BestWidth;
            if (!breaks) text.Append(' ');
            else
            {
                NewLine(text, continuation);
                // Escapes a space at the start of a line, because a reader ignores unescaped spaces there.
                if (value[i + 1] == ' ') text.Append('\\');
            }
        }
        text.Append('"');
    }

    static void AppendLetter(StringBuilder text, char letter)
    {
        switch (letter)
        {
            case '"': text.Append("\\\""); break;
            case '\\': text.Append("\\\\"); break;
            case '\n': text.Append("\\n"); break;
            case '\r': text.Append("\\r"); break;
            case '\t': text.Append("\\t"); break;
            case >= ' ' and <= '~': text.Append(letter); break;
            default: text.Append("\\u").Append(((int)letter).ToString("X4", CultureInfo.InvariantCulture)); break;
        }
    }

    static bool IsAlone(string value, int i) => i > 0 && i < value.Length - 1 && value[i - 1] != ' ' && value[i + 1] != ' ';

    static void NewLine(StringBuilder text, int continuation) => text.Append('\n').Append(' ', continuation);

    static int ColumnOf(StringBuilder text)
    {
        var column = 0;
        while (column < text.Length && text[text.Length - 1 - column] != '\n') column++;
        return column;
    }
}
