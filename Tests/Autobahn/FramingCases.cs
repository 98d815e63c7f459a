using static Nowpose.Headless.Tests.Autobahn.CaseScript;

namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>Cases for framing, pings, reserved bits and fragments: parts 1 to 3, 5 and 10 of the suite.</summary>
static class FramingCases
{
    const string Refused = "close:1002";

    static readonly int[] Sizes = [0, 125, 126, 127, 128, 65535, 65536];

    public static IEnumerable<AutobahnSection> All()
    {
        yield return Section("1.1.1–1.1.8", "text of 0, 125, 126, 127, 128, 65535, 65536 bytes, the last one also in pieces of 997",
            "Empty text is not JSON: the message is refused and the connection stays open.",
            [.. Sizes.Select((size, i) => Case($"1.1.{i + 1}", size == 0 ? "refused" : "accepted", s => Sized(s, Text, size))),
             Case("1.1.8", "accepted", s => { s.Chop = 997; Sized(s, Text, 65536); })]);
        yield return Section("1.2.1–1.2.8", "the same as binary",
            "rosbridge's JSON is text: binary messages are refused and the connection stays open.",
            [.. Sizes.Select((size, i) => Case($"1.2.{i + 1}", "refused", s => Sized(s, Binary, size))),
             Case("1.2.8", "refused", s => { s.Chop = 997; Sized(s, Binary, 65536); })]);
        yield return Section("2.1–2.6", "pings: empty, with text, with binary bytes, with 125 bytes, with 126 bytes, and with 125 bytes sent byte by byte", "",
            Case("2.1", "pong", s => s.SendPing()), Case("2.2", "pong", s => s.SendPing("Hello, world!")),
            Case("2.3", "pong", s => s.SendPing("\u0000\u0001\u007f\u0002")), Case("2.4", "pong", s => s.SendPing(new string('x', 125))),
            Case("2.5", Refused, s => s.SendPing(new string('x', 126))),
            Case("2.6", "pong", s => { s.Chop = 1; s.SendPing(new string('x', 125)); }));
        yield return Section("2.7–2.9", "unsolicited pongs, then a ping", "",
            Case("2.7", "", s => s.Frame(Pong)), Case("2.8", "", s => s.Frame(Pong, [1, 2, 3])),
            Case("2.9", "pong", s => { s.Frame(Pong, [1, 2, 3]); s.SendPing("ping"); }));
        yield return Section("2.10–2.11", "ten pings at once, whole and byte by byte", "",
            Case("2.10", Times("pong", 10), s => Ten(s)), Case("2.11", Times("pong", 10), s => { s.Chop = 1; Ten(s); }));
        yield return Section("3.1–3.2", "reserved bits on text, also after a valid message",
            "The other cases of parts 3 and 4, with reserved bits and opcodes, end the connection in the same way.",
            Case("3.1", Refused, s => s.Frame(Text, s.Message(), reserved: 1)),
            Case("3.2", AfterOne(Refused), s => { s.Send(); s.Frame(Text, s.Message(), reserved: 2); s.SendPing(); }));
        yield return Section("5.3–5.5", "text in two fragments: whole, in pieces, byte by byte", "",
            [.. new[] { 0, 20, 1 }.Select((chop, i) => Case($"5.{3 + i}", "accepted", s => { s.Chop = chop; s.SendFragments(s.Message(), 2); }))]);
        yield return Section("5.6–5.8", "the same with a ping between the fragments", "",
            [.. new[] { 0, 20, 1 }.Select((chop, i) =>
                Case($"5.{6 + i}", "pong accepted", s => { s.Chop = chop; s.SendFragments(s.Message(), 2, () => s.SendPing("between")); }))]);
        yield return Section("5.15", "a continuation frame without a first frame, after a message in two fragments", "",
            Case("5.15", AfterOne(Refused), s => { s.SendFragments(s.Message(), 2); s.Frame(Continuation, [3], isFinal: false); s.Send(); }));
        yield return Section("5.19–5.20", "text in five fragments with pings between", "",
            Case("5.19", "pong pong pong pong accepted", s => s.SendFragments(s.Message(), 5, () => s.SendPing("p"))),
            Case("5.20", "pong pong pong pong accepted", s => { s.Chop = 7; s.SendFragments(s.Message(), 5, () => s.SendPing("p")); }));
        yield return Section("10.1.1", "65536 bytes of text in fragments of 1300", "",
            Case("10.1.1", "accepted", s => s.SendFragments(s.Message(length: 65536), 51)));
    }

    public static AutobahnCase Case(string number, string expected, Action<CaseScript> play) => new(number, expected, s => play((CaseScript)s));

    public static AutobahnSection Section(string number, string what, string note, params AutobahnCase[] cases) => new(number, what, note, cases);

    public static string Times(string what, int times) => string.Join(' ', Enumerable.Repeat(what, times));

    /// <summary>Expects the given event. The response to the preceding valid message may be missing if the connection ends before it.</summary>
    public static string AfterOne(string expected) => $"accepted {expected}|{expected}";

    // Sends a message of the given size. A size that is too small for a valid message gives a longer, invalid frame; 0 gives an empty frame.
    static void Sized(CaseScript s, int opcode, int size)
    {
        var message = s.Message("", size);
        s.Frame(opcode, size == 0 ? [] : message);
    }

    static void Ten(CaseScript s)
    {
        for (var i = 0; i < 10; i++) s.SendPing("payload " + i);
    }
}
