using System.Globalization;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;

namespace Nowpose.Gateway.Verbs;

/// <summary>
/// Writes the output of a gateway at its start: lines of the form "key value" for other programs. The last line is "state serving".
/// </summary>
static class Announcement
{
    /// <summary>
    /// Writes the lines to the standard output, and warnings to stderr. If the standard output cannot be written, the gateway serves without these
    /// lines.
    /// </summary>
    /// <param name="gateway">The running gateway.</param>
    /// <param name="clock">The gateway's own clock.</param>
    /// <param name="skewPpm">Skew of the gateway's own clock.</param>
    /// <param name="robot">Name or path of the robot; null to omit the line.</param>
    /// <param name="cell">
    /// The cell of the gateway itself, whose clock is a <see cref="StopwatchControlClock"/>; null if the gateway serves a real plant, because the
    /// gateway cannot announce the motion and the clock of a real plant.
    /// </param>
    public static void Write(GatewayServer gateway, IControlClock clock, double skewPpm, string robot, SimulatedCell cell)
    {
        foreach (var warning in gateway.Warnings) Log(warning);
        if (gateway.VlcPageUris.Count == 0) Log(OperationsMessages.NoPage("vlc"));
        if (gateway.OperationsPageUris.Count == 0) Log(OperationsMessages.NoPage("operations"));
        if (gateway.PairsHeadsets && gateway.PairingPageUri == null) Log(OperationsMessages.NoPage("pair"));
        try
        {
            WriteLines(gateway, clock, skewPpm, robot, cell);
        }
        catch (IOException lost)
        {
            Log(lost.Message);
        }
    }

    static void WriteLines(GatewayServer gateway, IControlClock clock, double skewPpm, string robot, SimulatedCell cell)
    {
        Line("sync", gateway.SyncEndPoint.ToString());
        Line("websocket", $"{(gateway.Pin == null ? "ws" : "wss")}://{gateway.WebSocketEndPoint}/");
        foreach (var page in gateway.VlcPageUris) Line("vlc", page.ToString());
        foreach (var page in gateway.OperationsPageUris) Line("operations", page.ToString());
        Line("pair", gateway.PairingPageUri?.ToString());
        Line("pin", gateway.Pin?.ToString());
        Line("fingerprint", gateway.Fingerprint);
        Line("control_time_s", clock.Now.SinceEpoch.TotalSeconds.ToString("0.0000000", CultureInfo.InvariantCulture));
        Line("skew_ppm", skewPpm.ToString(CultureInfo.InvariantCulture));
        Line("robot", robot);
        if (cell != null)
        {
            Line("joints", string.Join(",", cell.Motion.JointNames));
            Line("cycle_s", cell.Motion.CycleSeconds.ToString("0.000", CultureInfo.InvariantCulture));
            Line("motion_start_ns", cell.Start.Nanoseconds.ToString(CultureInfo.InvariantCulture));
            var (intercept, rate) = ((StopwatchControlClock)clock).OverMonotonicCounter;
            Line("clock", string.Create(CultureInfo.InvariantCulture, $"c1_ns = {intercept} + {rate:R} * monotonic_ns"));
        }

        Line("state", "serving");
    }

    /// <summary>Writes one short line to stderr, with its time unless journald adds it.</summary>
    public static void LogWithTime(string line) => Log(
        Environment.GetEnvironmentVariable("JOURNAL_STREAM") == null
            ? DateTime.UtcNow.ToString("yyyy-MM-dd'T'HH:mm:ss.fff'Z '", CultureInfo.InvariantCulture) + line : line);

    /// <summary>Writes one short line to stderr.</summary>
    public static void Log(string line) => Console.Error.WriteLine(line);

    static void Line(string key, string value)
    {
        if (value != null)
            Console.Out.WriteLine($"{key} {value}");
    }
}
