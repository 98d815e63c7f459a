using System.Globalization;
using System.Text.RegularExpressions;
using Nowpose.Kinematics;
using Nowpose.Motion;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>Runs a simulated RTDE controller of a UR5e in another process. The robot picks and places, and the clock runs too fast.</summary>
sealed partial class RtdePlant : IPlantTruth, IDisposable
{
    const double Ppm = 60;

    readonly PeerProcess _program;
    readonly PickAndPlaceMotion _motion;

    RtdePlant(PeerProcess program, RobotModel robot)
    {
        _program = program;
        _motion = new PickAndPlaceMotion(robot);
    }

    [GeneratedRegex(@"^c1_ns = (-?\d+) \+ (\S+) \* monotonic_ns$")]
    private static partial Regex ClockLine();

    public static async Task<RtdePlant> StartAsync(RobotModel robot)
    {
        var ppm = Ppm.ToString(CultureInfo.InvariantCulture);
        var program = new PeerProcess("Nowpose.RtdeServer.dll", "--port", "0", "--uptime", "5000", "--ppm", ppm);
        await program.PrintsAsync("state serving");
        return new RtdePlant(program, robot);
    }

    /// <summary>Writes a configuration with which an adapter reads this plant, and returns the path of the file.</summary>
    public string Configure(string folder)
    {
        var path = Path.Combine(folder, "rtde.yaml");
        var port = _program.ValueOf("endpoint").Split(':')[1];
        File.WriteAllText(path, $"plant: {{ kind: rtde, name: arm, host: 127.0.0.1, port: {port} }}\nrobot: ur5e\n");
        return path;
    }

    public ControlTime TimeAt(HeadsetTime headset)
    {
        var line = ClockLine().Match(_program.ValueOf("clock"));
        var nanoseconds = decimal.Parse(line.Groups[1].Value, CultureInfo.InvariantCulture)
            + decimal.Parse(line.Groups[2].Value, CultureInfo.InvariantCulture) * headset.SinceEpoch.Ticks * 100m;
        return new ControlTime(new TimeSpan((long)Math.Round(nanoseconds / 100)));
    }

    public void TruthAt(RobotModel robot, ControlTime time, Span<double> positions) => _motion.At(time.SinceEpoch.TotalSeconds, positions);

    public void Dispose() => _program.Dispose();
}
