using System.Text;
using static Nowpose.Headless.Tests.Autobahn.CaseScript;
using static Nowpose.Headless.Tests.Autobahn.FramingCases;

namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>Cases that end connections: part 7 of the suite.</summary>
static class CloseCases
{
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
        yield return Section("7.7.1, 2, 9, 13", "codes that an endpoint may send",
            "The response has the code that was received. The cases with codes that an endpoint must not send, 7.9 and 7.13, end like 7.3.2.",
            [.. new[] { (1, 1000), (2, 1001), (9, 1011), (13, 4999) }
                .Select(one => Case($"7.7.{one.Item1}", $"close:{one.Item2}", s => s.SendClose(one.Item2)))]);
    }
}
