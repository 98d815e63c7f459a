using static Nowpose.Headless.Tests.Autobahn.CaseScript;
using static Nowpose.Headless.Tests.Autobahn.FramingCases;

namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>Cases with valid and invalid UTF-8: part 6 of the suite.</summary>
static class Utf8Cases
{
    const string Bad = "close:1007";
    const string Greek = "ce ba e1 bd b9 cf 83 ce bc ce b5";

    public static IEnumerable<AutobahnSection> All()
    {
        yield return Section("6.1.1–6.1.3", "empty text, three empty fragments, an empty fragment before and after a message",
            "Empty text is not JSON: the message is refused and the connection stays open.",
            Case("6.1.1", "refused", s => s.Frame(Text)),
            Case("6.1.2", "refused", s => { s.Frame(Text, isFinal: false); s.Frame(Continuation, isFinal: false); s.Frame(Continuation); }),
            Case("6.1.3", "accepted", s =>
            {
                s.Frame(Text, isFinal: false); s.Frame(Continuation, s.Message(),
                isFinal: false); s.Frame(Continuation);
            }));
        yield return Section("6.2.1–6.2.4", "characters of two and three bytes: whole, in two fragments, one fragment for each byte",
            "One fragment for each byte exceeds the maximum of 64 fragments of our protocol: the message is refused and the connection stays open.",
            Case("6.2.1", "accepted", s => s.Send("Hello-µ@ßöäüàá-UTF-8!!")), Case("6.2.2", "accepted",
                s => s.SendFragments(s.Message("Hello-µ@ßöäüàá-UTF-8!!"), 2)),
            Case("6.2.3", "refused", s => s.SendFragments(s.Message("Hello-µ@ßöäüàá-UTF-8!!"), 0)),
            Case("6.2.4", "refused", s => s.SendFragments(s.Message(Hex(Greek)), 0)));
        yield return Section("6.3.1–6.3.2", "half of a surrogate pair between valid characters: whole, one fragment for each byte", "",
            Case("6.3.1", Bad, s => s.Frame(Text, s.Message(Hex(Greek + " ed a0 80 65 64 69 74 65 64")))),
            Case("6.3.2", Bad, s => s.SendFragments(s.Message(Hex(Greek + " ed a0 80 65 64 69 74 65 64")), 0)));
        yield return Section("6.4.1–6.4.4",
            "a code point beyond Unicode in the second of three fragments, or in the middle of a frame: refused before the rest arrives", "",
            Case("6.4.1", Bad, s => Unfinished(s, "f4 90 80 80", 0)), Case("6.4.2", Bad, s => Unfinished(s, "f4 90", 0)),
            Case("6.4.3", Bad, s => Unfinished(s, "f4 90 80 80", 3)), Case("6.4.4", Bad, s => Unfinished(s, "f4 90", 3)));
        yield return Rows("6.5.1–6.5.5", "a Greek word: whole, and its characters one by one", "6.5", true, Greek, "ce ba", "e1 bd b9", "cf 83",
            "ce bc ce b5");
        yield return Rows("6.6.1, 3, 4, 6, 8, 10", "beginnings of this word that end within a character", "6.6", false,
            "ce", "ce ba e1", "ce ba e1 bd", "ce ba e1 bd b9 cf", "ce ba e1 bd b9 cf 83 ce", "ce ba e1 bd b9 cf 83 ce bc ce");
        yield return Rows("6.6.2, 5, 7, 9, 11", "beginnings of this word that end with a complete character", "6.6 whole", true,
            "ce ba", "ce ba e1 bd b9", "ce ba e1 bd b9 cf 83", "ce ba e1 bd b9 cf 83 ce bc", Greek);
        yield return Section("6.7.1–6.7.4", "the first character of each length in bytes",
            "NUL is a valid character, but JSON does not allow it in a string: the message is refused and the connection stays open.",
            Case("6.7.1", "refused", s => s.Frame(Text, s.Message([0]))), Letter("6.7.2", "c2 80"), Letter("6.7.3", "e0 a0 80"), Letter("6.7.4",
                "f0 90 80 80"));
        yield return Rows("6.8.1–6.8.2", "the first character of five bytes and of six bytes", "6.8", false, "f8 88 80 80 80", "fc 84 80 80 80 80");
        yield return Rows("6.9.1–6.9.4", "the last character of each length in bytes", "6.9", true, "7f", "df bf", "ef bf bf", "f4 8f bf bf");
        yield return Rows("6.10.1–6.10.3", "the last character of four, five and six bytes in the former definition of UTF-8", "6.10", false,
            "f7 bf bf bf", "fb bf bf bf bf", "fd bf bf bf bf bf");
        yield return Rows("6.11.1–6.11.4", "valid code points at a boundary", "6.11", true, "ed 9f bf", "ee 80 80", "ef bf bd", "f4 8f bf bf");
        yield return Rows("6.11.5", "the first code point beyond Unicode", "6.11 bad", false, "f4 90 80 80");
        yield return Rows("6.12.1–6.12.8", "continuation bytes without a first byte", "6.12", false,
            "80", "bf", "80 bf", "80 bf 80", "80 bf 80 bf", "80 bf 80 bf 80", "80 bf 80 bf 80 bf", Every(0x80, 0x3f, false));
        yield return Rows("6.13.1–6.13.5", "first bytes of sequences of two to six bytes, each before a space", "6.13", false,
            Every(0xc0, 32, true), Every(0xe0, 16, true), Every(0xf0, 8, true), Every(0xf8, 4, true), Every(0xfc, 2, true));
        yield return Rows("6.14.1–6.14.10, 6.15.1", "characters without their last byte, one by one and all together", "6.14", false,
            "c0", "e0 80", "f0 80 80", "f8 80 80 80", "fc 80 80 80 80", "df", "ef bf", "f7 bf bf", "fb bf bf bf", "fd bf bf bf bf",
            "c0 e0 80 f0 80 80 f8 80 80 80 fc 80 80 80 80 df ef bf f7 bf bf fb bf bf bf fd bf bf bf bf");
        yield return Rows("6.16.1–6.16.3", "bytes that never occur in UTF-8", "6.16", false, "fe", "ff", "fe fe ff ff");
        yield return Rows("6.17.1–6.17.5", "overlong encodings of a slash", "6.17", false, "c0 af", "e0 80 af", "f0 80 80 af",
            "f8 80 80 80 af", "fc 80 80 80 80 af");
        yield return Rows("6.18.1–6.18.5", "overlong encodings of the last character of each length", "6.18", false,
            "c1 bf", "e0 9f bf", "f0 8f bf bf", "f8 87 bf bf bf", "fc 83 bf bf bf bf");
        yield return Rows("6.19.1–6.19.5", "overlong encodings of NUL", "6.19", false, "c0 80", "e0 80 80", "f0 80 80 80", "f8 80 80 80 80",
            "fc 80 80 80 80 80");
        yield return Rows("6.20.1–6.20.7", "halves of surrogate pairs", "6.20", false,
            "ed a0 80", "ed ad bf", "ed ae 80", "ed af bf", "ed b0 80", "ed be 80", "ed bf bf");
        yield return Rows("6.21.1–6.21.8", "surrogate pairs encoded as two characters", "6.21", false,
            "ed a0 80 ed b0 80", "ed a0 80 ed bf bf", "ed ad bf ed b0 80", "ed ad bf ed bf bf", "ed ae 80 ed b0 80", "ed ae 80 ed bf bf",
            "ed af bf ed b0 80", "ed af bf ed bf bf");
        yield return Rows("6.22.1–6.22.34", "the noncharacters at the end of each plane", "6.22", true,
            [.. Enumerable.Range(0, 17).SelectMany(plane => new[] { plane << 16 | 0xfffe, plane << 16 | 0xffff }).Select(Bytes)]);
        yield return Rows("6.23.1–6.23.7", "the specials, U+FFF9 to U+FFFF", "6.23", true, [.. Enumerable.Range(0xfff9, 7).Select(Bytes)]);
    }

    static AutobahnSection Rows(string number, string what, string first, bool isGood, params string[] letters) => Section(
        number, what, "", [.. letters.Select((bytes, i) => isGood ? Letter($"{first}.{i + 1}", bytes) : Case($"{first}.{i + 1}", Bad,
            s => s.Frame(Text, s.Message(Hex(bytes)))))]);

    static AutobahnCase Letter(string number, string bytes) => Case(number, "accepted", s => s.Frame(Text, s.Message(Hex(bytes))));

    // Never completes the message, so a receiver that checks only complete messages would wait forever.
    static void Unfinished(CaseScript s, string bad, int chop)
    {
        s.Chop = chop;
        s.Frame(Text, Hex(Greek), isFinal: false);
        s.Frame(Continuation, Hex(bad), isFinal: false);
    }

    static string Every(int first, int count, bool withBlanks) =>
        string.Join(withBlanks ? " 20 " : " ", Enumerable.Range(first, count).Select(value => value.ToString("x2"))) + (withBlanks ? " 20" : "");

    static string Bytes(int codePoint) => string.Join(' ',
        System.Text.Encoding.UTF8.GetBytes(char.ConvertFromUtf32(codePoint)).Select(b => b.ToString("x2")));

    static byte[] Hex(string bytes) => Convert.FromHexString(bytes.Replace(" ", ""));
}
