using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;

namespace Nowpose.Peer;

/// <summary>Runs a headset session in a separate process. Prints a line at each change of state until the input ends.</summary>
static class HeadsetPeer
{
    static readonly TimeSpan FrameTime = TimeSpan.FromMilliseconds(16);

    public static void Run(string host, int syncPort, int webSocketPort, string pin, string token)
    {
        var connection = new ConnectionSettings(host, syncPort, webSocketPort, pin == null ? null : CertificatePin.Parse(pin), token: token);
        var clock = new StopwatchHeadsetClock();
        using var session = new CompensationSession(
            new SessionSettings(connection, new VisualisationLatency(TimeSpan.FromMilliseconds(40))), RobotFiles.Load("youbot"), clock);
        session.Connect();
        var ended = Task.Run(Console.In.ReadToEnd);
        var last = "";
        while (!ended.Wait(FrameTime))
        {
            var pose = session.Tick(clock.Now).State;
            var statistics = session.Statistics(clock.Now);
            var line = $"pose {pose} | clock {statistics.Clock.State} | sync {statistics.SyncLink} | positions {statistics.SampleLink}";
            if (line != last) Console.WriteLine(line);
            last = line;
        }
    }
}
