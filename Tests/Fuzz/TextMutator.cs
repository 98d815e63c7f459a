using System.Text;

namespace Nowpose.Headless.Tests.Fuzz;

/// <summary>Damages valid inputs. Mostly changes, adds, removes and swaps tokens that matter to a parser, instead of random characters.</summary>
/// <remarks>Most results are nearly valid, so that readers process most of the text before they detect the error. Not thread-safe.</remarks>
sealed class TextMutator
{
    static readonly string[] Numbers =
    [
        "0", "-0", "1", "-1", "0.0", "1e-400", "-1e-400", "1e308", "1.8e308", "-1.8e308", "1e999", "1e99999999999", "NaN", "-NaN", "Infinity",
        "-Infinity", "nan", "inf", "null", "true", "\"1\"", "[]", "{}", "4294967295", "4294967296", "-2147483649", "999999999", "1000000000",
        "9223372036854775807", "9223372036854775808", "-9223372036854775809", "18446744073709551616", "1e18", "0x10", "01", "+1", "1.", ".5",
        "1_000", "1,5", "1e", "٣", "170141183460469231731687303715884105728", "0.1e-5000", "5e-324", "1.7976931348623157e308",
    ];

    static readonly string[] Words =
    [
        "", " ", "\0", "\u0001", "\u007f", "\u0085", "\u2028", "\ud800", "\udc00", "\ufeff", "\u202e", "é", "🤖", "\\u0000", "\\ud800", "\\x41", "\\",
        "'", "\"", "../../etc/passwd", "%n%s", "<!--", "]]>", "&lt;", "&#0;", "&x;", "<!DOCTYPE a [<!ENTITY x \"y\">]>", "${x}", "#", ": ", "- ",
            "|", ">", "&a", "*a",
        "!!binary", "\t", "\r\n", "\n", "\r", "//", "/*", "?", "@",
    ];

    readonly List<string>[] _seeds;
    readonly string[] _pieces;

    /// <param name="seeds">Valid texts.</param>
    public TextMutator(params string[] seeds)
    {
        _seeds = [.. seeds.Select(Split)];
        _pieces = [.. _seeds.SelectMany(pieces => pieces).Distinct()];
    }

    /// <summary>Returns a damaged input, which is sometimes still valid.</summary>
    public string Next(Random random)
    {
        var pieces = _seeds[random.Next(_seeds.Length)].ToList();
        for (var n = random.Next(0, 5); n > 0 && pieces.Count > 0; n--) Spoil(pieces, random);
        var text = string.Concat(pieces);
        return random.Next(8) switch
        {
            0 => text[..random.Next(text.Length + 1)],
            1 => SpoilLetter(text, random),
            _ => text,
        };
    }

    void Spoil(List<string> pieces, Random random)
    {
        var at = random.Next(pieces.Count);
        switch (random.Next(11))
        {
            case 0: pieces.RemoveAt(at); break;
            case 1: pieces.Insert(at, pieces[at]); break;
            case 2: pieces.Insert(at, _pieces[random.Next(_pieces.Length)]); break;
            case 3: pieces[at] = _pieces[random.Next(_pieces.Length)]; break;
            case 4: pieces[at] = Words[random.Next(Words.Length)]; break;
            case 5: pieces[at] += Words[random.Next(Words.Length)]; break;
            case 6: Swap(pieces, at, random.Next(pieces.Count)); break;
            case 7: Nest(pieces, at, random); break;
            case 8: Stretch(pieces, at, random); break;
            default: ReplaceNumber(pieces, at, random); break;
        }
    }

    static void Swap(List<string> pieces, int a, int b) => (pieces[a], pieces[b]) = (pieces[b], pieces[a]);

    static void ReplaceNumber(List<string> pieces, int from, Random random)
    {
        for (var i = 0; i < pieces.Count; i++)
        {
            var at = (from + i) % pieces.Count;
            if (!IsNumber(pieces[at])) continue;
            pieces[at] = Numbers[random.Next(Numbers.Length)];
            return;
        }
    }

    static bool IsNumber(string piece) =>
        piece.Length > 0 && (char.IsAsciiDigit(piece[0]) || (piece.Length > 1 && piece[0] == '-' && char.IsAsciiDigit(piece[1])));

    static void Nest(List<string> pieces, int at, Random random)
    {
        var (open, close) = random.Next(3) switch { 0 => ("[", "]"), 1 => ("{\"a\":", "}"), _ => ("<a>", "</a>") };
        // Uses depths near the readers' limits, and sometimes far beyond them.
        var depth = random.Next(50) == 0 ? 5000 : random.Next(1, 24);
        pieces[at] = new StringBuilder().Insert(0, open, depth) + pieces[at] + new StringBuilder().Insert(0, close, depth);
    }

    static void Stretch(List<string> pieces, int at, Random random) =>
        pieces[at] = string.Concat(Enumerable.Repeat(pieces[at], random.Next(30) == 0 ? 3000 : random.Next(2, 140)));

    static string SpoilLetter(string text, Random random)
    {
        if (text.Length == 0) return text;
        var letters = text.ToCharArray();
        letters[random.Next(letters.Length)] = (char)(random.Next(4) == 0 ? random.Next(0x10000) : random.Next(0x80));
        return new string(letters);
    }

    // Splits the text into numbers, words and other individual characters.
    static List<string> Split(string text)
    {
        var pieces = new List<string>();
        for (var at = 0; at < text.Length;)
        {
            var end = at + 1;
            if (char.IsAsciiDigit(text[at]) || (text[at] == '-' && at + 1 < text.Length && char.IsAsciiDigit(text[at + 1])))
                while (end < text.Length && (char.IsAsciiDigit(text[end]) || text[end] is '.' or 'e' or 'E')) end++;
            else if (char.IsAsciiLetter(text[at]))
                while (end < text.Length && (char.IsAsciiLetterOrDigit(text[end]) || text[end] is '_' or '/')) end++;
            pieces.Add(text[at..end]);
            at = end;
        }
        return pieces;
    }
}
