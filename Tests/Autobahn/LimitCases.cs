using System.Text;
using static Nowpose.Headless.Tests.Autobahn.CaseScript;
using static Nowpose.Headless.Tests.Autobahn.FramingCases;

namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>Cases with long messages and many messages: part 9 of the suite, with the limits of this protocol in place of 16 MiB.</summary>
static class LimitCases
{
    const int MaxBytes = 1024 * 1024;

    public static IEnumerable<AutobahnSection> All()
    {
        yield return Section("9.1, 9.3, 9.5",
            "text of 64 KiB to 1 MiB (a robot description): in one frame, in 4, 16 and 64 fragments, in pieces of 64 KiB down to 1 KiB",
            "The maximum is 16 MiB in the suite and 1 MiB in our protocol.",
            [.. new[] { 65536, 262144, MaxBytes }.Select((size, i) => Case($"9.1.{i + 1}", "", s => s.Frame(Text, Description(size)))),
             .. new[] { 4, 16, 64 }.Select((count, i) => Case($"9.3.{i + 1}", "", s => s.SendFragments(Description(MaxBytes), count))),
             .. new[] { 65536, 8192, 1024 }.Select((chop, i) => Case($"9.5.{i + 1}", "", s => { s.Chop = chop; s.Frame(Text,
                 Description(MaxBytes)); }))]);
        yield return Section("9.1, 9.3 beyond", "one byte more than 1 MiB, one fragment more than 64",
            "The message exceeds our limits; the connection stays open.",
            Case("9.1.4", "refused", s => s.Frame(Text, Description(MaxBytes + 1))), Case("9.3.4", "refused",
                s => s.SendFragments(s.Message(length: 65 * 70), 65)));
        yield return Section("9.1.6", "text of 18 MiB",
            "The message is too long to be read and discarded, so the connection ends. The gateway sends 1009; a headset sends 1000 or disconnects.",
            Case("9.1.6", "close:1009|close:1000|", s => s.Frame(Text, Description(18 * MaxBytes))));
        yield return Section("9.7–9.8", "60 messages at once, of 60 to 1240 bytes; whole, and in pieces of 100",
            "The suite sends a thousand messages to measure the time; the gateway queues at most 64 responses for a client that does not read.",
            Case("9.7.1", Times("accepted", 60), Many), Case("9.8.1", Times("accepted", 60), s => { s.Chop = 100; Many(s); }));
    }

    static void Many(CaseScript s)
    {
        for (var i = 0; i < 60; i++) s.Send("number " + i, 60 + 20 * i);
    }

    static byte[] Description(int size)
    {
        const string Before = """{"op":"publish","topic":"/robot_description","msg":{"data":"<robot name='r'><link name='l'/></robot>""", After = "\"}}";
        return Encoding.UTF8.GetBytes(Before + new string(' ', size - Before.Length - After.Length) + After);
    }
}
