using System.Text;
using static Nowpose.Headless.Tests.Autobahn.CaseScript;
using static Nowpose.Headless.Tests.Autobahn.FramingCases;

namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>Cases that end connections: part 7 of the suite.</summary>
static class CloseCases
{
    static readonly int[] Good = [1000, 1001, 1002, 1003, 1007, 1008, 1009, 1010, 1011, 3000, 3999, 4000, 4999];
    static readonly int[] Wrong = [0, 999, 1004, 1005, 1006, 1016, 1100, 2000, 2999];

    public static IEnumerable<AutobahnSection> All()
    {
        yield return Section("7.1.1–7.1.6",
            "a close after a message, twice, before a ping, before a message, before the rest of a message, and after a long message",
            "The suite's long message is 256 KiB long; ours is 64 KiB long, the maximum of our protocol.",
            Case("7.1.1", AfterOne("close:1000"), s => { s.Send(); s.SendClose(1000); }),
            Case("7.1.2", "close:1000", s => { s.SendClose(1000); s.SendClose(1000); }),
            Case("7.1.3", "close:1000", s => { s.SendClose(1000); s.SendPing(); }),
            Case("7.1.4", "close:1000", s => { s.SendClose(1000); s.Send(); }),
            Case("7.1.5", "close:1000", s =>
            {
                s.Frame(Text, s.Message()[..5], isFinal: false); s.SendClose(1000); s.Frame(Continuation,
                s.Message()[5..]);
            }),
            Case("7.1.6", AfterOne("close:1000"), s => { s.Send(length: 65536); s.SendClose(1000); s.SendPing(); }));
        yield return Section("7.3.1–7.3.6",
            "a close without a code, with half a code, with a code, with a reason, with the longest reason, with one byte more",
            ".NET reports a close without a code as 1000, so the response has this code.",
            Case("7.3.1", "close:1000|close", s => s.Frame(CloseFrame)), Case("7.3.2", "close:1002", s => s.Frame(CloseFrame, [3])),
            Case("7.3.3", "close:1000", s => s.SendClose(1000)), Case("7.3.4", "close:1000", s => s.SendClose(1000,
                Encoding.UTF8.GetBytes("Hello World!"))),
            Case("7.3.5", "close:1000", s => s.SendClose(1000, new byte[123])), Case("7.3.6", "close:1002", s => s.SendClose(1000, new byte[124])));
        yield return Section("7.5.1", "a reason that is not UTF-8", "The suite expects 1007; .NET responds with 1002. Either ends the connection.",
            Case("7.5.1", "close:1007|close:1002", s => s.SendClose(1000, [0xce, 0xba, 0xed, 0xa0, 0x80])));
        yield return Section("7.7.1–7.7.13", "each code that an endpoint may send", "",
            [.. Good.Select((code, i) => Case($"7.7.{i + 1}", $"close:{code}",
            s => s.SendClose(code)))]);
        yield return Section("7.9.1–7.9.9", "codes that an endpoint must not send", "",
            [.. Wrong.Select((code, i) => Case($"7.9.{i + 1}", "close:1002",
            s => s.SendClose(code)))]);
        yield return Section("7.13.1–7.13.2", "codes beyond 4999", "The suite has no expectation; here the close is refused.",
            Case("7.13.1", "close:1002", s => s.SendClose(5000)), Case("7.13.2", "close:1002", s => s.SendClose(65535)));
    }
}
