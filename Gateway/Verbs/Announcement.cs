using System.Globalization;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.VisibleLight;
using Nowpose.Motion;

namespace Nowpose.Gateway.Verbs;

/// <summary>What a gateway that runs by itself says of itself: lines "key value" that other programs can read, the last "state serving".</summary>
static class Announcement
{
    public static void Write(GatewayServer gateway, IControlClock clock, double skewPpm, string robot, IMotion motion)
    {
        Line("sync", gateway.SyncEndPoint.ToString());
        Line("websocket", $"{(gateway.Pin == null ? "ws" : "wss")}://{gateway.WebSocketEndPoint}/");
        foreach (var page in gateway.CodePageUris) Line("vlc", page.ToString());
        if (gateway.CodePageUris.Count == 0) Log("vlc: " + HtmlPage.Missing);
        foreach (var page in gateway.OperationsPageUris) Line("operations", page.ToString());
        if (gateway.OperationsPageUris.Count == 0) Log("operations: " + HtmlPage.Missing);
        Line("pair", gateway.PairingPageUri?.ToString());
        if (gateway.PairsHeadsets && gateway.PairingPageUri == null) Log("pair: " + HtmlPage.Missing);
        Line("pin", gateway.Pin?.ToString());
        Line("control_time_s", clock.Now.SinceEpoch.TotalSeconds.ToString("0.0000000", CultureInfo.InvariantCulture));
        Line("skew_ppm", skewPpm.ToString(CultureInfo.InvariantCulture));
        Line("robot", robot);
        if (motion != null)
        {
            Line("joints", string.Join(",", motion.JointNames));
            Line("cycle_s", motion.CycleSeconds.ToString("0.000", CultureInfo.InvariantCulture));
        }

        foreach (var warning in gateway.Warnings) Log(warning);
        Line("state", "serving");
    }

    /// <summary>One short line on stderr.</summary>
    public static void Log(string line) => Console.Error.WriteLine(line);

    static void Line(string key, string value)
    {
        if (value != null)
            Console.Out.WriteLine($"{key} {value}");
    }
}
