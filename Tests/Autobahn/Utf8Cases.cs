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
        yield return Section("6.3.1", "half of a surrogate pair between valid characters",
            "The other cases of part 6 with invalid characters end the connection in the same way.",
            Case("6.3.1", Bad, s => s.Frame(Text, s.Message(Hex(Greek + " ed a0 80 65 64 69 74 65 64")))));
        yield return Section("6.4.1", "a code point beyond Unicode in the second of three fragments: refused before the rest arrives", "",
            Case("6.4.1", Bad, s => Unfinished(s, "f4 90 80 80")));
        yield return Section("6.7.1, 3, 4", "the first character of one, three and four bytes",
            "NUL is a valid character, but JSON does not allow it in a string: the message is refused and the connection stays open.",
            Case("6.7.1", "refused", s => s.Frame(Text, s.Message([0]))), Letter("6.7.3", "e0 a0 80"), Letter("6.7.4", "f0 90 80 80"));
        yield return Section("6.22.1–6.22.2", "the noncharacters at the end of the first plane", "",
            Letter("6.22.1", "ef bf be"), Letter("6.22.2", "ef bf bf"));
    }

    static AutobahnCase Letter(string number, string bytes) => Case(number, "accepted", s => s.Frame(Text, s.Message(Hex(bytes))));

    // Never completes the message, so a receiver that checks only complete messages would wait forever.
    static void Unfinished(CaseScript s, string bad)
    {
        s.Frame(Text, Hex(Greek), isFinal: false);
        s.Frame(Continuation, Hex(bad), isFinal: false);
    }

    static byte[] Hex(string bytes) => Convert.FromHexString(bytes.Replace(" ", ""));
}
