using System.Text;
using static Nowpose.Headless.Tests.Autobahn.CaseScript;
using static Nowpose.Headless.Tests.Autobahn.FramingCases;

namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>Long messages and many messages: part 9 of the suite, at the limits of our protocol instead of 16 MiB.</summary>
static class LimitCases
{
    const int Longest = 1024 * 1024;

    public static IEnumerable<AutobahnSection> All()
    {
        yield return Section("9.1, 9.3, 9.5",
            "text of 64 KiB to 1 MiB (a robot description): in one frame, in 4, 16 and 64 fragments, in pieces of 64 KiB down to 1 KiB",
            "The suite goes to 16 MiB, our protocol to 1.",
            [.. new[] { 65536, 262144, Longest }.Select((size, i) => Case($"9.1.{i + 1}", "", s => s.Frame(Text, Description(size)))),
             .. new[] { 4, 16, 64 }.Select((count, i) => Case($"9.3.{i + 1}", "", s => s.SendFragments(Description(Longest), count))),
             .. new[] { 65536, 8192, 1024 }.Select((chop, i) => Case($"9.5.{i + 1}", "", s => { s.Chop = chop; s.Frame(Text,
                 Description(Longest)); }))]);
        yield return Section("9.1, 9.3 beyond", "a byte more than 1 MiB, a fragment more than 64", "Beyond our limits; the connection stays open.",
            Case("9.1.4", "refused", s => s.Frame(Text, Description(Longest + 1))), Case("9.3.4", "refused",
                s => s.SendFragments(s.Message(length: 65 * 70), 65)));
        yield return Section("9.1.6", "text of 18 MiB", "Beyond what is read over: the connection ends. The gateway says 1009; a headset just closes.",
            Case("9.1.6", "close:1009|close:1000|", s => s.Frame(Text, Description(18 * Longest))));
        yield return Section("9.7–9.8", "60 messages at once, of 60 to 1240 bytes; whole, and in pieces of 100",
            "The suite measures time with a thousand; the gateway keeps 64 answers for who does not read.",
            Case("9.7.1", Times("taken", 60), Many), Case("9.8.1", Times("taken", 60), s => { s.Chop = 100; Many(s); }));
    }

    static void Many(CaseScript s)
    {
        for (var i = 0; i < 60; i++) s.Send("number " + i, 60 + 20 * i);
    }

    static byte[] Description(int size)
    {
        const string Before = """{"op":"publish","topic":"/robot_description","msg":{"data":"<robot/>""", After = "\"}}";
        return Encoding.UTF8.GetBytes(Before + new string(' ', size - Before.Length - After.Length) + After);
    }
}
