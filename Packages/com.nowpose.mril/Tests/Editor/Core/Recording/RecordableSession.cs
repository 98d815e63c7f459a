using Newtonsoft.Json;
using Newtonsoft.Json.Linq;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Recording;
using Nowpose.Session;
using Nowpose.Sync;
using Nowpose.Tests.Core.Session;

namespace Nowpose.Tests.Core.Recording
{
    /// <summary>Creates a session that can be recorded, and sync exchanges for it.</summary>
    static class RecordableSession
    {
        public static readonly HeadsetTime Start = HeadsetTime.FromSeconds(100);

        /// <summary>Creates a session with a secret token and a name that JSON must escape.</summary>
        public static CompensationSession NewSession(string robotNamespace = "") => new CompensationSession(
            new SessionSettings(
                new ConnectionSettings("127.0.0.1", token: "very-secret", headsetName: "test \"one\"\n"), new VisualisationLatency(Lengths.Ms(40)),
                range: new ConstantLatencyRange(15.2, RenderTimeSourceKind.GpuCompletion), robotNamespace: robotNamespace),
            TestRobot.Model, new SetClock());

        /// <summary>Returns an exchange that ends at this time and took 2 ms.</summary>
        public static SyncExchange Exchange(HeadsetTime at, double resolutionMs = 0) => new SyncExchange(
            at - Lengths.Ms(2), new ControlTime(at.SinceEpoch), new ControlTime(at.SinceEpoch), at, Lengths.Ms(resolutionMs), Lengths.Ms(0.3));

        public static void Synchronise(CompensationSession session)
        {
            for (var i = 1; i <= 4; i++) session.Clock.Add(Exchange(Start + Lengths.Ms(200 * i)), out _);
        }
    }
}
